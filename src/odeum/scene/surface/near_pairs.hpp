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

  /// Looks again where that is necessary at the places q; then use(pair) for those that may meet.
  template <class Use>
  std::size_t visit(const Surfaces& surfaces, const double* q, const Use& use) {
    double moved = id_ == surfaces.id() ? moved_to(q) : far;
    if (!(surfaces.shrinks * moved <= margin_)) {
      id_ = surfaces.id();
      margin_ = surfaces.thickness();
      places_.assign(q, q + surfaces.numbers());
      surfaces.find_near(q, margin_, pairs_);
      moved = 0;
    }
    for (const SurfacePair& pair : pairs_)
      if (pair.slack <= surfaces.shrinks * moved) use(pair);
    return pairs_.size();
  }
  /// Of the straight way from q to the places of the last visit: whether the pairs hold on it.
  bool hold_from(const Surfaces& surfaces, const double* q) const {
    return surfaces.shrinks * moved_to(q) <= margin_;
  }
  const std::vector<SurfacePair>& pairs() const { return pairs_; }

 private:
  double moved_to(const double* q) const {
    double most = 0, not_finite = 0;
    for (std::size_t i = 0; i < places_.size(); i += 3) {
      const double x = q[i] - places_[i], y = q[i + 1] - places_[i + 1],
                   z = q[i + 2] - places_[i + 2], squared = x * x + y * y + z * z;
      most = squared > most ? squared : most;
      not_finite += squared * 0;
    }
    return not_finite == 0 ? std::sqrt(most) : far;
  }

  static constexpr double far = std::numeric_limits<double>::max();
  std::uint64_t id_ = 0;
  double margin_ = 0;
  std::vector<double> places_;
  std::vector<SurfacePair> pairs_;
};

}  // namespace odeum::scene
