// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

#include "odeum/control/adaptive.hpp"
#include "odeum/core/lanes.hpp"

namespace odeum {

/// A StepClock for the member in each lane, with the same operations in the same order.
class LaneClock {
 public:
  void set(std::size_t lane, double t0, double first_step) {
    const StepClock one(t0, first_step);
    t_.set(lane, one.t());
    h_.set(lane, one.h());
  }
  /// Begins a trial step; false in a lane where it is at the rounding of t.
  LaneMask begin(double target) {
    last_ = t_ + h_ >= target - rounding * std::abs(target);
    used_ = select(last_, target - t_, h_);
    target_ = target;
    return h_ >= max(rounding * abs(t_), std::numeric_limits<double>::min());
  }
  void end(const LaneMask& accept, const Lanes& next_step) {
    h_ = select(accept & last_, max(h_, next_step), next_step);
    t_ = select(accept, select(last_, target_, t_ + used_), t_);
  }
  const Lanes& t() const { return t_; }
  const Lanes& used() const { return used_; }

 private:
  static constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  Lanes t_ = 0, h_ = 0, used_ = 0, target_ = 0;
  LaneMask last_{};
};

}  // namespace odeum
