// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "odeum/kernel/iteration.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/problem/concepts.hpp"

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

}  // namespace odeum
