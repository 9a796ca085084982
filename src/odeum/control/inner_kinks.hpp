// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Looks for a jump or a kink of f among the evaluations of a trial step. An estimate whose weights
/// leave out nodes, or nearly cancel after some of them, is zero or far too small where f jumps
/// there, whatever the tolerance is. Between two neighbouring nodes a jump stands out by a slope of
/// f, a kink by a second difference, that is several times those beside it; what the step can be
/// off is then bounded by the gap between the nodes.
template <Ode P>
class InnerKinks {
 public:
  /// Before a trial step, of which the sample that was kept is the start.
  void begin() {
    count_ = 0;
    if (kept_.f.empty()) return;
    if (samples_.empty()) samples_.emplace_back();
    samples_[count_++] = kept_;
  }
  /// The last in time, after a trial step that is accepted.
  void keep_end() {
    if (count_ == 0) return;
    const auto end = samples_.begin() + static_cast<std::ptrdiff_t>(count_);
    kept_ = *std::max_element(samples_.begin(), end,
                              [](const Sample& a, const Sample& b) { return a.t < b.t; });
  }
  /// Keeps an evaluation of n components from index `first` on, among `size`.
  void note(double t, const double* values, std::size_t n, std::size_t first, std::size_t size) {
    if (count_ == samples_.size()) samples_.emplace_back();
    Sample& sample = samples_[count_++];
    sample.t = t;
    sample.f.assign(size, std::numeric_limits<double>::quiet_NaN());
    std::copy(values, values + n, sample.f.begin() + static_cast<std::ptrdiff_t>(first));
  }
  /// Whether a kink within the step of h to y matters. `damp(x)`: see SlopeRange.
  template <class Damp>
  bool matters(double h, const State<P>& y, const ErrorScale<State<P>>& scale, Damp&& damp) {
    sort(h);
    if (count_ < 4) return false;
    off_ = y;
    if (!exceeds(y, scale, [&](std::size_t i) { return off_by(i); })) return false;
    damp(off_);
    return exceeds(y, scale, [&](std::size_t i) { return off_[i]; });
  }

 private:
  struct Sample {
    double t = 0;
    std::vector<double> f;
  };

  template <class Off>
  bool exceeds(const State<P>& y, const ErrorScale<State<P>>& scale, const Off& off) {
    constexpr double matters = 30;  // times the tolerance
    bool found = false;
    for (std::size_t i = 0; i < y.size(); ++i) {
      off_[i] = off(i);
      found = found || std::abs(off_[i]) > matters * scale(i, std::abs(y[i]));
    }
    return found;
  }

  /// Sorts the samples by time; among evaluations at nearly the same time the last is the most
  /// accurate.
  void sort(double h) {
    const auto end = samples_.begin() + static_cast<std::ptrdiff_t>(count_);
    std::stable_sort(samples_.begin(), end,
                     [](const Sample& a, const Sample& b) { return a.t < b.t; });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      if (kept > 0 && samples_[k].t - samples_[kept - 1].t <= 1e-3 * h) --kept;
      if (kept != k) std::swap(samples_[kept], samples_[k]);
      ++kept;
    }
    count_ = kept;
  }

  double gap(std::size_t k) const { return samples_[k + 1].t - samples_[k].t; }
  double slope(std::size_t i, std::size_t k) const {
    return (samples_[k + 1].f[i] - samples_[k].f[i]) / gap(k);
  }

  /// The error that component i may have, with the sign of the jump; 0: nothing stands out.
  double off_by(std::size_t i) const {
    constexpr double stands_out = 5;
    double off = 0;
    const auto take = [&](double other) { off = std::abs(other) > std::abs(off) ? other : off; };
    const std::size_t gaps = count_ - 1;
    std::array<double, 3> bends{};  // the largest
    std::size_t bend_at = 0;
    for (std::size_t k = 0; k < gaps; ++k) {
      const double here = slope(i, k), before = k > 0 ? slope(i, k - 1) : 0,
                   after = k + 1 < gaps ? slope(i, k + 1) : 0;
      if (std::abs(here) > stands_out * std::max(std::abs(before), std::abs(after)))
        take(here * gap(k) * gap(k));
      if (k == 0) continue;
      const double bend = std::abs(here - before) / (gap(k - 1) + gap(k));
      if (bend > bends[0]) bend_at = k;
      bends = bend > bends[0]   ? std::array{bend, bends[0], bends[1]}
              : bend > bends[1] ? std::array{bends[0], bend, bends[1]}
                                : std::array{bends[0], bends[1], std::max(bends[2], bend)};
    }
    // A kink bends two neighbours, an inaccurate evaluation three.
    if (gaps > 3 && bends[0] > stands_out * bends[2]) {
      const double wide = std::max(gap(bend_at - 1), gap(bend_at));
      take((slope(i, bend_at) - slope(i, bend_at - 1)) * wide * wide / 4);
    }
    return off;
  }

  std::vector<Sample> samples_;  ///< the first `count_` of them
  std::size_t count_ = 0;
  Sample kept_ = {};  ///< without values: none
  State<P> off_{};
};

}  // namespace odeum
