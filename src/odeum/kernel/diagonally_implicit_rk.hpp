// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <utility>

#include "odeum/control/predictive.hpp"
#include "odeum/kernel/newton.hpp"
#include "odeum/tableau/tableau.hpp"

namespace odeum {

/// Stages that depend on earlier ones and themselves only.
template <std::size_t S>
constexpr bool is_diagonally_implicit(const Tableau<S>& tableau) {
  for (std::size_t i = 0; i < S; ++i)
    for (std::size_t j = i + 1; j < S; ++j)
      if (tableau.a[i][j] != 0) return false;
  return true;
}

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
  static_assert(is_diagonally_implicit(T));
  static constexpr std::size_t stages = T.stages;

  explicit DiagonallyImplicitRungeKutta(const P& problem)
      : problem_(problem), newton_(problem), base_(make_state(problem)), stage_(base_) {
    k_.fill(base_);
  }

  /// For adaptive runs: solve the stages to a fraction of the tolerance instead of to rounding.
  void solve_to(double tolerance) { newton_.solve_to(tolerance, 0.02); }

  Status step(double t, double h, State<P>& y) {
    const Status status = solve_stages(t, h, y);
    if (status == Status::ok) finish(h, y);
    return status;
  }

  /// The same step; `error` becomes h sum_i (b_i - b_hat_i) k_i.
  Status step(double t, double h, State<P>& y, State<P>& error) requires(T.embedded()) {
    const Status status = solve_stages(t, h, y);
    if (status != Status::ok) return status;
    for (std::size_t n = 0; n < y.size(); ++n) {
      double sum = 0;
      for (std::size_t i = 0; i < stages; ++i) sum += (T.b[i] - T.b_hat[i]) * k_[i][n];
      error[n] = h * sum;
    }
    finish(h, y);
    return Status::ok;
  }

 private:
  /// The last stage is the new state.
  static constexpr bool stiffly_accurate = T.a[stages - 1] == T.b;

  Status solve_stages(double t, double h, const State<P>& y) {
    for (std::size_t i = 0; i < stages; ++i) {
      for (std::size_t n = 0; n < y.size(); ++n) {
        double sum = 0;
        for (std::size_t j = 0; j < i; ++j) sum += T.a[i][j] * k_[j][n];
        base_[n] = y[n] + h * sum;
      }
      const double gamma_h = h * T.a[i][i], stage_time = t + T.c(i) * h;
      if (gamma_h == 0) {
        problem_.rhs(stage_time, base_.data(), k_[i].data());
        stage_ = base_;
        continue;
      }
      // Initial guess: the slope of the previous stage.
      stage_ = base_;
      if (i > 0)
        for (std::size_t n = 0; n < y.size(); ++n) stage_[n] += gamma_h * k_[i - 1][n];
      const Status status = newton_.solve(stage_time, gamma_h, base_, stage_);
      if (status != Status::ok) return status;
      for (std::size_t n = 0; n < y.size(); ++n) k_[i][n] = (stage_[n] - base_[n]) / gamma_h;
    }
    return Status::ok;
  }

  void finish(double h, State<P>& y) {
    if constexpr (stiffly_accurate) {
      y = stage_;
    } else {
      for (std::size_t n = 0; n < y.size(); ++n) {
        double sum = 0;
        for (std::size_t i = 0; i < stages; ++i) sum += T.b[i] * k_[i][n];
        y[n] += h * sum;
      }
    }
  }

  const P& problem_;
  Newton<P> newton_;
  std::array<State<P>, stages> k_;
  State<P> base_, stage_;
};

/// The adaptive run of an implicit one-step method with an embedded estimate, whose Stepper has
/// `solve_to`. `order` is that of the estimate. The step is kept where it would grow by little, so
/// that the next step reuses the factors.
template <class Stepper, Ode P>
Outcome run_implicit_pair(const Guarded<P>& problem, double t0, const State<P>& y0,
                          const Request& request, int order) {
  Stepper stepper(problem);
  stepper.solve_to(request.tolerance);
  State<P> error = make_state(problem);
  PredictiveController controller(order);
  const auto trial = [&](double t, double h, const State<P>& y, State<P>& y_new, double& norm) {
    y_new = y;
    const Status status = stepper.step(t, h, y_new, error);
    norm = scaled_error_norm(error, y, y_new, request.tolerance);
    return status;
  };
  const auto decide = [&](double h, double norm) {
    Decision decision = controller.decide(h, norm);
    if (decision.accept && decision.next_step >= h && decision.next_step < 1.2 * h)
      decision.next_step = h;
    return decision;
  };
  const double first =
      initial_step(problem, t0, y0, request.stops.back(), order, request.tolerance);
  return run_adaptive(problem, t0, y0, request, first, trial, decide);
}

/// Base of a method that is a diagonally implicit tableau and nothing else.
template <const auto& T>
struct DiagonallyImplicitMethod {
  static constexpr const auto& tableau = T;
  template <class P>
  using Stepper = DiagonallyImplicitRungeKutta<T, P>;
  static double amplification(double re, double im) {
    return std::abs(stability_function(T, {re, im}));
  }
};

/// The same with an embedded row.
template <const auto& T>
struct DiagonallyImplicitPair : DiagonallyImplicitMethod<T> {
  static_assert(T.embedded());
  template <class P>
  static Outcome integrate(const Guarded<P>& problem, double t0, const State<P>& y0,
                           const Request& request) {
    using Stepper = DiagonallyImplicitRungeKutta<T, Guarded<P>>;
    return run_implicit_pair<Stepper>(problem, t0, y0, request, std::min(T.order, T.order_hat));
  }
};

}  // namespace odeum
