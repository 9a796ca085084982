// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/newton.hpp"

namespace odeum {

/// One step of any diagonally implicit Runge-Kutta method on any problem: for each stage the
/// equation
///
///     Y_i = y + h sum_{j<i} a_ij k_j + h a_ii f(t + c_i h, Y_i),   k_i = f(t + c_i h, Y_i),
///
/// by Newton's method, and y <- y + h sum_i b_i k_i. A stage with a_ii = 0 is evaluated. Where the
/// diagonal is the same in all stages they share one factorisation. k_i is taken from the equation:
/// evaluating f would multiply Newton's remaining error by the stiffness.
template <const auto& T, Ode P>
class DiagonallyImplicitRungeKutta {
 public:
  static_assert(T.is_diagonally_implicit());
  static constexpr std::size_t stages = T.stages;

  explicit DiagonallyImplicitRungeKutta(const P& problem)
      : problem_(problem),
        newton_(problem, newton_weight),
        base_(make_state(problem)),
        stage_(base_),
        before_(base_),
        by_slope_(base_),
        slope_is_closer_(base_) {
    k_.fill(base_);
  }

  static constexpr bool keeps_factors = true;  ///< as long as h is the same
  void will_be_retried() { newton_.will_be_retried(); }
  void solve_to(const Tolerance& tolerance) {
    newton_.solve_to(tolerance, fraction_for_stages<T>(tolerance));
  }

  Status step(double t, double h, State<P>& y) {
    const Status status = solve_stages(t, h, y);
    if (status == Status::ok) finish(h, y);
    return status;
  }

  /// The same step; `error` becomes h sum_i (b_i - b_hat_i) k_i.
  Status step(double t, double h, State<P>& y, State<P>& error) requires(T.embedded()) {
    const Status status = solve_stages(t, h, y);
    if (status != Status::ok) return status;
    each_component(y, [&](std::size_t n) {
      double sum = 0;
      for (std::size_t i = 0; i < stages; ++i) sum += (T.b[i] - T.b_hat[i]) * k_[i][n];
      error[n] = h * sum;
    });
    finish(h, y);
    return Status::ok;
  }

 private:
  /// The last stage is the new state.
  static constexpr bool stiffly_accurate = T.a[stages - 1] == T.b;
  /// k_i = (Y_i - base) / (h a_ii): the new state has the remainder of Y_i times b_i / a_ii.
  static constexpr double newton_weight = [] {
    double weight = 1;
    for (std::size_t i = 0; i < stages; ++i)
      if (T.a[i][i] != 0) weight = std::max({weight, T.b[i] / T.a[i][i], -T.b[i] / T.a[i][i]});
    return weight;
  }();

  Status solve_stages(double t, double h, const State<P>& y) {
    for (std::size_t i = 0; i < stages; ++i) {
      each_component(y, [&](std::size_t n) {
        double sum = 0;
        for (std::size_t j = 0; j < i; ++j) sum += T.a[i][j] * k_[j][n];
        base_[n] = y[n] + h * sum;
      });
      const double gamma_h = h * T.a[i][i], stage_time = t + T.c(i) * h;
      if (gamma_h == 0) {
        problem_.rhs(stage_time, base_.data(), k_[i].data());
        stage_ = base_;
        continue;
      }
      before_ = i > 0 ? stage_ : base_;
      stage_ = base_;
      if (i > 0) guess(gamma_h, k_[i - 1]);
      const Status status = newton_.solve(stage_time, gamma_h, base_, stage_, before_);
      if (status != Status::ok) return status;
      if (i > 0) compare_guesses();
      each_component(y, [&](std::size_t n) { k_[i][n] = newton_.increment()[n] / gamma_h; });
    }
    return Status::ok;
  }

  /// The initial guess of a component: by the slope of the previous stage, or its state, which is
  /// closer where a stiff component follows the others; whichever was closer in the last stage. A
  /// guess beyond the solution may lead to another one.
  void guess(double gamma_h, const State<P>& slope) {
    each_component(stage_, [&](std::size_t n) {
      by_slope_[n] = base_[n] + gamma_h * slope[n];
      stage_[n] = slope_is_closer_[n] != 0 ? by_slope_[n] : before_[n];
    });
  }
  void compare_guesses() {
    each_component(stage_, [&](std::size_t n) {
      slope_is_closer_[n] =
          std::abs(stage_[n] - by_slope_[n]) < std::abs(stage_[n] - before_[n]) ? 1 : 0;
    });
  }

  void finish(double h, State<P>& y) {
    if constexpr (stiffly_accurate) {
      y = stage_;
    } else {
      each_component(y, [&](std::size_t n) {
        double sum = 0;
        for (std::size_t i = 0; i < stages; ++i) sum += T.b[i] * k_[i][n];
        y[n] += h * sum;
      });
    }
  }

  const P& problem_;
  Newton<P> newton_;
  std::array<State<P>, stages> k_;
  State<P> base_, stage_, before_, by_slope_;
  State<P> slope_is_closer_;
};

/// Base of a method that is a diagonally implicit tableau and nothing else.
template <const auto& T>
struct DiagonallyImplicitMethod : TableauMethod<T> {
  template <class P>
  using Stepper = DiagonallyImplicitRungeKutta<T, P>;
  static constexpr MethodInfo described(MethodInfo info) {
    return completed(info, "implicit_rk", T);
  }
};

}  // namespace odeum
