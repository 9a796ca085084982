// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/newton_iteration.hpp"

namespace odeum {

/// Moves y towards a solution of y = base + gamma_h f(t, y) from where Newton's method does not get
/// to it, by steps with a bound of the Jacobian (ShiftedSolver::bound). For springs each lowers the
/// energy whose minimum is the solution (majorisation), so that they do not end at a singular
/// Jacobian, but they converge slowly: Newton's method takes over. False: the problem's solver has
/// no bound, or a step is not finite.
template <Ode P>
bool bounded_steps([[maybe_unused]] const P& problem, [[maybe_unused]] double t,
                   [[maybe_unused]] double gamma_h, [[maybe_unused]] const State<P>& base,
                   [[maybe_unused]] State<P>& y, [[maybe_unused]] int count) {
  if constexpr (WithShiftedSolver<P>) {
    const auto solver = problem.shifted_solver();
    if (!solver || !solver->bound()) return false;
    State<P> step = base;
    for (int k = 0; k < count; ++k) {
      problem.rhs(t, y.data(), step.data());
      for (std::size_t i = 0; i < y.size(); ++i) step[i] = base[i] + gamma_h * step[i] - y[i];
      if (!solver->factorise(t, y.data(), gamma_h)) return false;
      if (!solver->solve(step.data(), correction_accuracy)) return false;
      if (!std::isfinite(max_norm(step))) return false;
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += step[i];
    }
    return true;
  }
  return false;
}

/// To what fraction of the tolerance an adaptive run with a tableau solves its stages, instead of
/// to rounding. With an estimate of order q the error of a step of order p goes as
/// tol^((p+1)/(q+1)): a remainder of Newton's iteration that stays proportional to the tolerance
/// would take the order from the run.
template <const auto& T>
double fraction_for_stages(const Tolerance& tolerance) {
  constexpr double gained = std::max(0, T.order - T.order_hat) / (T.order_hat + 1.0);
  return std::min(0.02, 0.05 * std::pow(tolerance.relative, gained));
}

/// Newton's method, and where that fails at a step that is not retried shorter: Newton's method
/// from a state that steps with a bound of the Jacobian lead to.
template <Ode P>
class Newton {
 public:
  /// `weight`: what the method multiplies the remainder of a solution by, at least 1.
  explicit Newton(const P& problem, double weight = 1)
      : problem_(problem), iteration_(problem, weight) {}

  /// A step that fails will be repeated shorter, which is cheaper than steps with a bound.
  void will_be_retried() { retried_ = true; }
  /// See NewtonIteration.
  void solve_to(const Tolerance& tolerance, double fraction) {
    will_be_retried();
    iteration_.solve_to(tolerance, fraction);
  }
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y,
               const State<P>& otherwise) {
    Status status = iteration_.solve(t, gamma_h, base, y, otherwise);
    if (status == Status::ok || retried_) return status;
    constexpr int most_steps = 640;
    State<P> closer = otherwise;
    for (int count = 10; count <= most_steps && status != Status::ok; count *= 2) {
      if (!bounded_steps(problem_, t, gamma_h, base, closer, count)) break;
      y = closer;
      status = iteration_.solve(t, gamma_h, base, y, closer);
    }
    return status;
  }
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y) {
    const State<P> otherwise = y;
    return solve(t, gamma_h, base, y, otherwise);
  }
  const State<P>& increment() const { return iteration_.increment(); }

 private:
  const P& problem_;
  NewtonIteration<P> iteration_;
  bool retried_ = false;
};

}  // namespace odeum
