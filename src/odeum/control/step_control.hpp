// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "odeum/control/adaptive.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/quick_power.hpp"

/// Controllers: a decision from the scaled error of a step, 1 at the tolerance,
///
///     Decision operator()(double h, double error);
///
/// With q the order of the estimate the error goes as h^k, k = q + 1; 0.9 is the safety factor.
namespace odeum {

/// The controller's decision; without a finite error the step is repeated with a quarter of it.
template <class StepControl>
Decision decide(StepControl& control, double h, double error) {
  return std::isfinite(error) ? control(h, error) : Decision{false, h / 4};
}

/// For methods whose factors hold for one length of step: a step that would grow by little is kept.
inline Decision without_small_growth(Decision decision, double h) {
  if (decision.accept && decision.next_step >= h && decision.next_step < 1.2 * h)
    decision.next_step = h;
  return decision;
}

/// h <- h * 0.9 err^(-1/k), by a factor of 0.2 to 5 (Hairer, Norsett, Wanner, Solving ODEs I,
/// (II.4.13)).
class IntegralControl {
 public:
  static constexpr const char* name = "embedded pair, integral control";
  explicit IntegralControl(int order) : power_(order + 1) {}
  Decision operator()(double h, double error) const {
    return {error <= 1, h * factor(0.9 * quick_power(std::max(error, 1e-10), -1 / power_))};
  }
  static double factor(double wanted) { return std::clamp(wanted, 0.2, 5.0); }

 private:
  double power_;
};

/// Proportional-integral: h <- h * 0.9 err_n^(-0.7/k) err_{n-1}^(0.4/k) after an accepted step,
/// integral after a rejected one, and no growth in the step that follows it (Gustafsson, ACM TOMS
/// 17 (1991) 533-554; Hairer, Wanner, Solving ODEs II, IV.2).
class ProportionalIntegralControl {
 public:
  static constexpr const char* name = "embedded pair, proportional-integral control";
  explicit ProportionalIntegralControl(int order) : power_(order + 1) {}
  Decision operator()(double h, double error) {
    error = std::max(error, 1e-10);
    if (error > 1) {
      rejected_ = true;
      return {false, h * IntegralControl::factor(0.9 * quick_power(error, -1 / power_))};
    }
    const double damped =
        0.9 * quick_power(error, -0.7 / power_) * quick_power(last_error_, 0.4 / power_);
    const double wanted = IntegralControl::factor(damped);
    last_error_ = std::max(error, 1e-4);  // a single very small error does not limit the next step
    return {true, h * (std::exchange(rejected_, false) ? std::min(wanted, 1.0) : wanted)};
  }

 private:
  double power_;
  double last_error_ = 1;
  bool rejected_ = false;
};

/// Integral control that leaves h unchanged while the error is in [0.4, 1], where it would change h
/// by little: a constant step needs no new coefficients, factorisation or pow.
class DeadBandControl {
 public:
  static constexpr const char* name = "embedded pair, integral control with a dead band";
  static constexpr double low = 0.4;
  explicit DeadBandControl(int order) : integral_(order) {}
  Decision operator()(double h, double error) const {
    return error >= low && error <= 1 ? Decision{true, h} : integral_(h, error);
  }

 private:
  IntegralControl integral_;
};

/// Gustafsson's predictive control for stiff problems (Solving ODEs II, IV.8, (8.20)): the errors
/// of the last two accepted steps are extrapolated, so that a step that must shrink along the
/// solution shrinks before it is rejected.
class PredictiveControl {
 public:
  static constexpr const char* name = "embedded pair, predictive";
  explicit PredictiveControl(int order, double largest_growth = 6)
      : exponent_(1.0 / (order + 1)), largest_growth_(largest_growth) {}

  [[gnu::always_inline]] Decision operator()(double h, double error) {
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

/// The controllers in the order of the enumeration Control.
template <Control control>
struct ControlFor {
  using type = std::tuple_element_t<
      static_cast<std::size_t>(control),
      std::tuple<IntegralControl, ProportionalIntegralControl, DeadBandControl, PredictiveControl>>;
};

}  // namespace odeum
