// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "odeum/scene/surface/surfaces.hpp"

namespace odeum::scene {

/// The pairs that may meet as long as no particle has moved too far from where it was when they
/// were looked for. All that is left out of them has no force, so that what is computed does not
/// depend on when that was.
class NearPairs {
 public:
  /// One for each thread, since threads share surfaces.
  static NearPairs& of_thread() {
    thread_local NearPairs near;
    return near;
  }

  /// All pairs that may meet at the positions q, and some others; always in the same order.
  const std::vector<SurfacePair>& at(const Surfaces& surfaces, const double* q) {
    double shrunk = id_ == surfaces.id() ? surfaces.shrinks * moved_to(q) : far;
    if (!(shrunk <= margin_)) {
      choose_margin(surfaces);
      places_.assign(q, q + surfaces.numbers());
      surfaces.find_near(q, margin_, pairs_);
      shrunk = 0;
      within_ = -1;
    }
    ++visits_;
    if (shrunk > within_) {
      within_ = std::min(std::max(2 * shrunk, margin_ / 8), margin_);
      nearest_.clear();
      for (const SurfacePair& pair : pairs_)
        if (pair.slack <= within_) nearest_.push_back(pair);
    }
    return nearest_;
  }
  /// Whether the pairs hold on the straight way from q to the positions of the last visit.
  bool hold_from(const Surfaces& surfaces, const double* q) const {
    return surfaces.shrinks * moved_to(q) <= margin_;
  }
  /// Whether the parts of one of the pairs may touch while no particle has moved farther.
  static bool may_touch(const SurfacePair& pair, double moved) {
    return std::max(pair.distance, pair.slack) <= Surfaces::shrinks * moved;
  }
  const std::vector<SurfacePair>& pairs() const { return pairs_; }

  /// How far a particle has moved at most, but for what all have moved together.
  double moved_to(const double* q) const {
    double mean[3] = {0, 0, 0};
    for (std::size_t i = 0; i < places_.size(); ++i) mean[i % 3] += q[i] - places_[i];
    for (double& component : mean) component *= 3 / static_cast<double>(places_.size());
    double most = 0, not_finite = 0;
    for (std::size_t i = 0; i < places_.size(); i += 3) {
      const double x = q[i] - places_[i] - mean[0], y = q[i + 1] - places_[i + 1] - mean[1],
                   z = q[i + 2] - places_[i + 2] - mean[2], squared = x * x + y * y + z * z;
      most = squared > most ? squared : most;
      not_finite += squared * 0;
    }
    return not_finite == 0 ? std::sqrt(most) : far;
  }

 private:
  /// A wide margin holds for longer, and has more pairs to go through at each visit. A search costs
  /// some 20 visits.
  void choose_margin(const Surfaces& surfaces) {
    constexpr double narrowest = 1.0 / 32, first = 1.0 / 8;
    const double thickness = surfaces.thickness();
    if (id_ != surfaces.id())
      margin_ = first * thickness;
    else if (visits_ < 10)
      margin_ = std::min(2 * margin_, thickness);
    else if (visits_ > 80)
      margin_ = std::max(margin_ / 2, narrowest * thickness);
    id_ = surfaces.id();
    visits_ = 0;
  }

  static constexpr double far = std::numeric_limits<double>::max();
  std::uint64_t id_ = 0;
  double margin_ = 0;
  std::size_t visits_ = 0;  ///< since the search
  std::vector<double> places_;
  double within_ = -1;  ///< the largest slack of those that follow
  std::vector<SurfacePair> pairs_, nearest_;
};

}  // namespace odeum::scene
