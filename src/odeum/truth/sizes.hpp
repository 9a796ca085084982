// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "odeum/truth/along.hpp"

namespace odeum::truth {

/// The size of each component so far, by which errors are measured: a component that passes through
/// zero has no relative error. One that has always been small is measured with the largest, but not
/// by less than a part of that, unless its size along the solution is known (System::along) and
/// that is far smaller. One that falls and rises again is measured by what it is at each time.
class Sizes {
 public:
  /// `memory`: what remains of an earlier size after a step, down to 1e-4 of the component's
  /// largest.
  Sizes(const System& system, const State& y, Real least_part, Real memory)
      : now(y.size(), 0), peaks_(system.peaks), least_part_(least_part), memory_(memory) {
    peaks_.resize(y.size());
    if (system.along) along_ = system.along.get();
    update(y);
  }

  /// Whether all has been zero.
  bool none_yet() const {
    return std::ranges::all_of(peaks_, [](Real peak) { return peak == 0; });
  }
  /// Takes sizes to be at least this, for one step.
  void expect(Real size) {
    for (Real& each : now) each = std::max(each, size);
    expected_ = true;
  }
  const State& peaks() const { return peaks_; }

  void update(const State& y) {
    // From zero a solution may rise through numbers that are too small to matter.
    Real largest = 1e-34L;
    if (expected_) std::ranges::fill(now, 0);
    expected_ = false;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const Real size = std::abs(y[i]);
      peaks_[i] = std::max(peaks_[i], size);
      now[i] = falls_and_rises(i) ? size : std::max({memory_ * now[i], size, 1e-4L * peaks_[i]});
      largest = std::max(largest, now[i]);
    }
    for (std::size_t i = 0; i < y.size(); ++i) now[i] = std::max(now[i], least(i, largest));
  }

  State now;

 private:
  bool falls_and_rises(std::size_t i) const { return along_ && along_->dips[i] > 0; }
  Real least(std::size_t i, Real largest) const {
    const Real usual = least_part_ * largest;
    if (!along_) return usual;
    // A component has a relative error of 1e6 tolerances at most.
    const Real own = falls_and_rises(i) ? along_->dips[i] : along_->largest[i];
    return own > 0 ? std::min(usual, 1e6L * own) : usual;
  }

  const Along* along_ = nullptr;
  State peaks_;
  bool expected_ = false;  ///< the sizes are those of expect()
  Real least_part_, memory_;
};

inline Real size_of(const State& y) {
  Real largest = 0;
  for (const Real x : y) largest = std::max(largest, std::abs(x));
  return largest;
}

inline Real largest_ratio(const State& error, const State& sizes) {
  Real worst = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const Real ratio = sizes[i] > 0 ? std::abs(error[i]) / sizes[i] : std::abs(error[i]);
    if (std::isnan(ratio)) return ratio;
    worst = std::max(worst, ratio);
  }
  return worst;
}

/// The largest of the components of `size`, which are about those of `state`, in the units.
inline Real largest_of(const State& size, const State& state, const ErrorUnits& units) {
  Real worst = 0;
  for (std::size_t i = 0; i < size.size(); ++i) {
    const Real difference = std::abs(size[i]) / units.of(i, static_cast<double>(state[i]));
    if (std::isnan(difference)) return difference;
    worst = std::max(worst, difference);
  }
  return worst;
}

inline State difference_of(State a, const State& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::abs(a[i] - b[i]);
  return a;
}

/// The larger of both, by component.
inline void extend(State& largest, const State& by) {
  for (std::size_t i = 0; i < by.size(); ++i) largest[i] = std::max(largest[i], std::abs(by[i]));
}

}  // namespace odeum::truth
