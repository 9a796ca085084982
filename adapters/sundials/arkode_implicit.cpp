// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>

#include <utility>

#include "sundials/arkode.hpp"
#include "sundials/newton.hpp"
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {
namespace {

// At a fixed step the tolerances only control Newton's iteration, so they are set to its accuracy,
// and the matrix is rebuilt in each step. Adaptive runs use the library's defaults.
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
  create_arkstep(session, nullptr, Session::rhs);
  check(ARKStepSetTableNum(session.integrator(), id, ARKODE_ERK_NONE), "setting the table");
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

  // The library's default tables of orders 2 to 5 again, with the one setting that keeps its error
  // control correct on linear problems (reports/findings/sundials.md).
  for (const int id : {ARKSTEP_DEFAULT_DIRK_2, ARKSTEP_DEFAULT_DIRK_3, ARKSTEP_DEFAULT_DIRK_4,
                       ARKSTEP_DEFAULT_DIRK_5}) {
    for (std::size_t i = 0; i < implicit_tables().size(); ++i) {
      if (implicit_tables()[i].id != id) continue;
      Method method = list[i];
      method.info.method += "_matrix_each_stage";
      method.info.fixed = false;
      method.info.source +=
          ", with its matrix rebuilt at each stage (ARKStepSetLSetupFrequency(-1))";
      method.build = [build_default = method.build](Session& session) {
        build_default(session);
        check(ARKStepSetLSetupFrequency(session.integrator(), -1),
              "setting the frequency of linear solver setups");
      };
      list.push_back(std::move(method));
    }
  }
  return list;
}

}  // namespace odeum::adapters::sundials
