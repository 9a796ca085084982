// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/newton.hpp"
#include "odeum/tableau/order_conditions.hpp"

namespace odeum::methods {

/// Implicit (backward) Euler: the tangent at the end of the step, y_{n+1} = y_n + h f(t_{n+1},
/// y_{n+1}).
inline constexpr Tableau<1> implicit_euler_tableau{
    .a = {{{1}}},
    .b = {1},
    .order = 1,
};
static_assert(proven(implicit_euler_tableau));

struct implicit_euler : ForAnyProblem {
  static constexpr MethodInfo info{
      .id = "implicit_euler",
      .family = "implicit_rk",
      .order = implicit_euler_tableau.order,
      .source =
          "Cauchy 1824; Hairer, Wanner, Solving ODEs II, (IV.1.2); Newton's method as in IV.8"};
  static constexpr const auto& tableau = implicit_euler_tableau;

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem) : newton_(problem), y_next_(make_state(problem)) {}

    Status step(double t, double h, State<P>& y) {
      y_next_ = y;
      const Status status = newton_.solve(t + h, h, y, y_next_);
      y = y_next_;
      return status;
    }

   private:
    Newton<P> newton_;
    State<P> y_next_;
  };

  static double amplification(double re, double im) {
    return std::abs(stability_function(implicit_euler_tableau, {re, im}));
  }
};

}  // namespace odeum::methods
