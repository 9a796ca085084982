// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "odeum/control/run_method.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum {

/// Solves with method M; the type of the problem is known down to the innermost loop.
template <class M, Ode P>
Outcome solve_own(const Contest<P>& contest, const Request& request) {
  Guard guard(size_of(*contest.problem), request.budget, &request.tolerance);
  const Guarded<P> problem(*contest.problem, guard);
  State<P> y0 = make_state(*contest.problem);
  std::copy(contest.y0->begin(), contest.y0->end(), y0.begin());
  Outcome outcome = run_method<M>(problem, contest.t0, y0, request);
  guard.conclude(request, outcome);
  return outcome;
}

/// Puts M on a contest of a type that it fits.
template <class M, Ode P>
void enroll_as(const Contest<P>& contest, Entrant& entrant) {
  if constexpr (requires { M::fits_problem(*contest.problem); })
    if (!M::fits_problem(*contest.problem)) return;
  entrant.unfit.clear();
  entrant.solve = [contest](const Request& request) { return solve_own<M>(contest, request); };
}

}  // namespace odeum
