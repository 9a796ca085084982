// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "odeum/control/adaptive.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/quick_power.hpp"

/// Controllers: a decision from the square of the scaled error of a step, 1 at the tolerance,
///
///     Decision operator()(double h, double square);
///
/// With q the order of the estimate the error goes as h^k, k = q + 1; 0.9 is the safety factor. The
/// square saves a root, since only powers of the error are needed.
namespace odeum {
inline namespace ODEUM_ROUNDING {  // see kernel/quick_power.hpp

/// The controller's decision; without a finite error the step is repeated with a quarter of it.
template <class StepControl>
Decision decide(StepControl& control, double h, double square) {
  return std::isfinite(square) ? control(h, square) : Decision{false, h / 4};
}

/// Keeps a step that would grow by little: some methods' factors hold for one length of step.
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
  explicit IntegralControl(int order) : power_(power_of_square<100>(order + 1)) {}
  Decision operator()(double h, double square) const {
    return {square <= 1, h * factor(0.9 * power_(square))};
  }
  static double factor(double wanted) { return std::clamp(wanted, 0.2, 5.0); }

 private:
  const FixedPower& power_;
};

/// Proportional-integral: h <- h * 0.9 err_n^(-0.7/k) err_{n-1}^(0.4/k) after an accepted step,
/// integral after a rejected one, and no growth in the step that follows it (Gustafsson, ACM TOMS
/// 17 (1991) 533-554; Hairer, Wanner, Solving ODEs II, IV.2).
class ProportionalIntegralControl {
 public:
  static constexpr const char* name = "embedded pair, proportional-integral control";
  explicit ProportionalIntegralControl(int order)
      : integral_(order), power_(power_of_square<70>(order + 1)), exponent_(0.2 / (order + 1)) {}
  Decision operator()(double h, double square) {
    if (square > 1) {
      rejected_ = true;
      return integral_(h, square);
    }
    const double wanted = IntegralControl::factor(0.9 * power_(square) * last_);
    // A single very small error does not limit the next step.
    last_ = quick_power(std::max(square, 1e-8), exponent_);
    return {true, h * (std::exchange(rejected_, false) ? std::min(wanted, 1.0) : wanted)};
  }

 private:
  IntegralControl integral_;
  const FixedPower& power_;
  double exponent_;
  double last_ = 1;  ///< the part of the last error
  bool rejected_ = false;
};

/// Integral control that leaves h unchanged while the error is in [0.4, 1], where it would change h
/// by little: a constant step needs no new coefficients, factorisation or pow.
class DeadBandControl {
 public:
  static constexpr const char* name = "embedded pair, integral control with a dead band";
  static constexpr double low = 0.4;
  explicit DeadBandControl(int order) : integral_(order) {}
  Decision operator()(double h, double square) const {
    return square >= low * low && square <= 1 ? Decision{true, h} : integral_(h, square);
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
      : power_(power_of_square<100>(order + 1)),
        largest_(power_(1e-4)),
        largest_growth_(largest_growth) {}

  Decision operator()(double h, double square) {
    const double root = power_(square);
    double factor = safety * root;
    if (square <= 1) {
      if (last_step_ > 0)
        factor = std::min(factor, safety * (h / last_step_) * (root * root / last_root_));
      last_step_ = h;
      last_root_ = std::min(root, largest_);
      factor = std::clamp(factor, 0.2, after_rejection_ ? 1.0 : largest_growth_);
      after_rejection_ = false;
      return {true, h * factor};
    }
    after_rejection_ = true;
    return {false, h * std::clamp(factor, 0.1, 0.9)};
  }

 private:
  static constexpr double safety = 0.9;
  const FixedPower& power_;          ///< err^(-1/k)
  double largest_, largest_growth_;  ///< of an error of 1e-2
  double last_step_ = 0, last_root_ = 0;
  bool after_rejection_ = false;
};

/// The controllers in the order of the enumeration Control.
template <Control control>
struct ControlFor {
  using type = std::tuple_element_t<
      static_cast<std::size_t>(control),
      std::tuple<IntegralControl, ProportionalIntegralControl, DeadBandControl, PredictiveControl>>;
};

}  // namespace ODEUM_ROUNDING
}  // namespace odeum
