// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "odeum/control/adaptive.hpp"
#include "odeum/kernel/bdf_variable.hpp"

namespace odeum {

/// Trial steps of backward differences with a quasi-constant step, and their order: among k - 1, k
/// and k + 1 the one that allows the longest step (Shampine, Reichelt, section 2). Stops before the
/// last are interpolated.
template <Ode P>
class BdfTrial {
 public:
  BdfTrial(const P& problem, double t0, const State<P>& y0, double first_step,
           const Tolerance& tolerance)
      : stepper_(problem, t0, y0, first_step, tolerance) {}

  Decision operator()(double t, double h, const State<P>&, State<P>& y_new) {
    if (h != stepper_.h()) rescale(h / stepper_.h());
    if (stepper_.solve(t + h, order_) != Status::ok) return reject(0.3);
    constexpr double most = 2.0 * Stepper::max_iterations;
    const double safety = 0.9 * (most + 1) / (most + stepper_.iterations());
    const double error = stepper_.error(order_);
    if (!(error <= 1))
      return reject(std::isfinite(error) ? std::max(0.2, safety * factor_of(error, order_)) : 0.2);
    // Newton's method sees the end of a step alone, and what is another in between may be as before
    // there; a step like the last one has been looked at by its differences.
    constexpr double like_the_last = 2;
    if (made_ > 0 && h > like_the_last * made_ && !stepper_.even_in_the_middle(t, order_))
      return reject(0.5);
    stepper_.advance(order_);
    t_ = t + h;
    made_ = h;
    y_new = stepper_.state();
    if (++equal_steps_ > order_) choose_order(error, safety);
    return {true, stepper_.h()};
  }
  static constexpr bool always_over_stops = true;
  Status between(const StepMade<State<P>>&, double time, State<P>& y) const {
    stepper_.interpolate(time, t_, order_, y);
    return Status::ok;
  }

 private:
  using Stepper = BdfStepper<P>;

  static double factor_of(double error, int order) {
    return quick_power(std::max(error, 1e-10), -1.0 / (order + 1));
  }
  Decision reject(double factor) {
    rescale(factor);
    return {false, stepper_.h()};
  }
  void rescale(double factor) {
    stepper_.rescale(factor, order_);
    equal_steps_ = 0;
  }

  void choose_order(double error, double safety) {
    const int k = order_;
    double best = factor_of(error, k);
    const auto try_order = [&](int order, double error_then) {
      const double factor = factor_of(error_then, order);
      if (factor > best) best = factor, order_ = order;
    };
    if (k > 1) try_order(k - 1, stepper_.error_of_lower(k));
    if (k < Stepper::max_order) try_order(k + 1, stepper_.error_of_higher(k));
    const double factor = std::min(10.0, safety * best);
    // A small change of the step is not made, so that the factors can be reused.
    if (factor < 1 || factor >= 1.2 || order_ != k) rescale(factor);
  }

  Stepper stepper_;
  double t_ = 0, made_ = 0;  ///< the end of the last step, and its length
  int order_ = 1, equal_steps_ = 0;
};

}  // namespace odeum
