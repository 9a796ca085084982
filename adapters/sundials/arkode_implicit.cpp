// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>

#include "sundials/arkode_tables.hpp"
#include "sundials/newton.hpp"
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {
namespace {

// At a fixed step the tolerances serve Newton's iteration alone, so they are set to what it is to
// reach, and the matrix is made anew in each step. To a tolerance all is left to the library.
void solve_stages_exactly(Session& session) {
  void* const arkstep = session.integrator();
  const double coefficient = 0.1;  // the library's default
  const double tolerance = exact_solve_tolerance(session) / coefficient;
  check(ARKStepSStolerances(arkstep, tolerance, tolerance), "setting the tolerances");
  check(ARKStepSetNonlinConvCoef(arkstep, coefficient), "setting the convergence coefficient");
  check(ARKStepSetMaxNonlinIters(arkstep, max_exact_iterations), "setting the limit of iterations");
  check(ARKStepSetLSetupFrequency(arkstep, 1), "setting the frequency of linear solver setups");
  check(ARKStepSetJacEvalFrequency(arkstep, 1), "setting the frequency of Jacobians");
}

void build(Session& session, ARKODE_DIRKTableID id) {
  session.adopt(ARKStepCreate(nullptr, Session::rhs, session.t0(), session.y(), session.context()));
  void* const arkstep = session.integrator();
  // Every stop is a step's end, so nothing is interpolated; this interpolant needs no evaluations.
  check(ARKStepSetInterpolantType(arkstep, ARK_INTERP_LAGRANGE), "setting the interpolant");
  check(ARKStepSetInterpolantDegree(arkstep, 1), "setting the interpolant's degree");
  check(ARKStepSetTableNum(arkstep, id, ARKODE_ERK_NONE), "setting the table");
  attach_linear_solver(session);
  if (session.fixed_step()) solve_stages_exactly(session);
}

}  // namespace

std::vector<Method> arkode_implicit_methods() {
  std::vector<Method> list;
  for (const ImplicitTable& table : implicit_tables())
    list.push_back(
        {describe_table("arkstep_" + table.method, "implicit_rk", table.order, table.order_embedded,
                        "ARKODE ARKStep, implicit, built-in table ARKODE_" + table.name +
                            "; Newton iteration"),
         &arkstep_module, [id = table.id](Session& session) { build(session, id); }});
  return list;
}

}  // namespace odeum::adapters::sundials
