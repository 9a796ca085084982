// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <utility>

#include "odeum/control/adaptive.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/quick_power.hpp"

/// The next step from the scaled error of the last one. With q the lower order of the pair the
/// error goes as h^k, k = q + 1; 0.9 is the safety factor; h changes by a factor of 0.2 to 5 per
/// step.
namespace odeum {

/// h <- h * 0.9 err^(-1/k)  (Hairer, Norsett, Wanner, Solving ODEs I, (II.4.13)).
class IntegralControl {
 public:
  static constexpr const char* name = "embedded pair, integral control";
  explicit IntegralControl(int lower_order) : power_(lower_order + 1) {}
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
  explicit ProportionalIntegralControl(int lower_order) : power_(lower_order + 1) {}
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
  explicit DeadBandControl(int lower_order) : integral_(lower_order) {}
  Decision operator()(double h, double error) const {
    return error >= low && error <= 1 ? Decision{true, h} : integral_(h, error);
  }

 private:
  IntegralControl integral_;
};

template <Control>
struct ControlFor {
  using type = IntegralControl;
};
template <>
struct ControlFor<Control::proportional_integral> {
  using type = ProportionalIntegralControl;
};
template <>
struct ControlFor<Control::dead_band> {
  using type = DeadBandControl;
};

}  // namespace odeum
