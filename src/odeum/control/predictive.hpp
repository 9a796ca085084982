// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "odeum/control/adaptive.hpp"
#include "odeum/kernel/quick_power.hpp"

namespace odeum {

/// Gustafsson's predictive control for stiff problems (Solving ODEs II, IV.8, (8.20)): the errors
/// of the last two accepted steps are extrapolated, so that a step that must shrink along the
/// solution shrinks before it is rejected. `order` is that of the error estimate, whose size goes
/// with h^(order+1).
class PredictiveController {
 public:
  explicit PredictiveController(int order, double largest_growth = 6)
      : exponent_(1.0 / (order + 1)), largest_growth_(largest_growth) {}

  Decision decide(double h, double error) {
    const double bounded = std::max(error, 1e-10);
    double factor = safety * quick_power(bounded, -exponent_);
    if (error <= 1) {
      if (last_error_ > 0) {
        const double predicted =
            safety * (h / last_step_) * quick_power(last_error_ / (bounded * bounded), exponent_);
        factor = std::min(factor, predicted);
      }
      last_step_ = h;
      last_error_ = std::max(bounded, 1e-2);
      factor = std::clamp(factor, 0.2, after_rejection_ ? 1.0 : largest_growth_);
      after_rejection_ = false;
      return {true, h * factor};
    }
    after_rejection_ = true;
    return {false, h * std::clamp(factor, 0.1, 0.9)};
  }

 private:
  static constexpr double safety = 0.9;
  double exponent_, largest_growth_;
  double last_step_ = 0, last_error_ = 0;
  bool after_rejection_ = false;
};

}  // namespace odeum
