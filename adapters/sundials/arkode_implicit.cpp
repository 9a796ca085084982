// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "odeum/methods/ars222.hpp"
#include "odeum/methods/ars443.hpp"
#include "sundials/arkode.hpp"
#include "sundials/later_tables.hpp"
#include "sundials/newton.hpp"
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {
namespace {

// At a fixed step the tolerances only control Newton's iteration, so they are set to its accuracy,
// and the matrix is rebuilt in each step.
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

// To a tolerance, with a direct solver: a matrix for each stage, whose derivative follows from the
// solved stage without an evaluation (deduced), and a first iterate extrapolated from the last
// step. The guide describes all three; over the stiff cases they take a tenth of the default's time
// to an error of 1e-2 and a quarter to 1e-6, and solve 283 of 294 runs instead of 98
// (reports/peers.md).
void solve_stages_newly(Session& session) {
  void* const arkstep = session.integrator();
  check(ARKStepSetLSetupFrequency(arkstep, -1), "setting the frequency of linear solver setups");
  check(ARKStepSetDeduceImplicitRhs(arkstep, 1), "deducing stage derivatives");
  check(ARKStepSetPredictorMethod(arkstep, 1), "setting the predictor");
}

enum class Settings { best, library_default };

/// Sets the table of an implicit method in ARKStep.
using SetTable = std::function<int(void* arkstep)>;

void build(Session& session, const SetTable& set_table, Settings settings) {
  create_arkstep(session, nullptr, Session::rhs);
  check(set_table(session.integrator()), "setting the table");
  attach_linear_solver(session);
  if (session.fixed_step())
    solve_stages_exactly(session);
  else if (settings == Settings::best && factorises(session))
    solve_stages_newly(session);
}

Method implicit_method(const std::string& name, int order, int order_embedded,
                       const std::string& source, Settings settings, SetTable set_table) {
  SolverInfo info = describe_table("arkstep_" + name, "implicit_rk", order, order_embedded,
                                   "ARKODE ARKStep, implicit, " + source + "; Newton iteration");
  if (settings == Settings::library_default) {
    info.method += "_default_settings";
    info.fixed = false;
    info.source += ", every setting of its Newton iteration left at the library's default";
  }
  return {
      std::move(info), &arkstep_module,
      [set = std::move(set_table), settings](Session& session) { build(session, set, settings); }};
}

Method built_in(const ImplicitTable& table, Settings settings) {
  return implicit_method(
      table.method, table.order, table.order_embedded,
      "built-in table ARKODE_" + table.name + default_of(table.name), settings,
      [id = table.id](void* arkstep) { return ARKStepSetTableNum(arkstep, id, ARKODE_ERK_NONE); });
}

Method ark2() {
  std::shared_ptr<ARKodeButcherTableMem> table = as_butcher_table(ark2_dirk_3_1_2);
  const std::string name = "ARK2_DIRK_3_1_2";
  return implicit_method("user_ark2_dirk_3_1_2", ark2_dirk_3_1_2.order, ark2_dirk_3_1_2.order_hat,
                         "with the table ARKODE_" + name + " of SUNDIALS 7.3.0" + default_of(name),
                         Settings::best, [table](void* arkstep) {
                           return ARKStepSetTables(arkstep, table->q, table->p, table.get(),
                                                   nullptr);
                         });
}

/// A pair of tables: what sets it, and its orders.
Method imex_method(const std::string& name, int order, int order_embedded,
                   const std::string& source, SetTable set_tables) {
  SolverInfo info = describe_table("arkstep_imex_" + name, "imex_rk", order, order_embedded,
                                   "ARKODE ARKStep, additive, " + source + "; Newton iteration");
  info.needs = ForSplit::needs;
  return {std::move(info), &arkstep_module,
          [set = std::move(set_tables)](Session& session) {
            create_arkstep(session, Session::explicit_part, Session::rhs);
            check(set(session.integrator()), "setting the tables");
            attach_linear_solver(session);
            if (session.fixed_step())
              solve_stages_exactly(session);
            else if (factorises(session))
              solve_stages_newly(session);
          },
          true};
}

/// A built-in pair, whose two tables differ by a word in their names.
Method built_in_pair(const ImplicitTable& implicit, const ExplicitTable& explicit_table) {
  const auto without = [](std::string name, const char* word) {
    return name.erase(name.find(word), std::string(word).size());
  };
  return imex_method(without(implicit.method, "_dirk"), implicit.order, implicit.order_embedded,
                     "built-in tables ARKODE_" + implicit.name + " and ARKODE_" +
                         explicit_table.name + default_of(without(implicit.name, "_DIRK")),
                     [i = implicit.id, e = explicit_table.id](void* arkstep) {
                       return ARKStepSetTableNum(arkstep, i, e);
                     });
}

/// The coefficients of an own method.
template <class M, std::size_t S>
Method user_pair(const AdditiveTableau<S>& tableau) {
  const std::string id(M::info.id);
  std::shared_ptr<ARKodeButcherTableMem> implicit = as_butcher_table(tableau.implicit_half),
                                         outer = as_butcher_table(tableau.explicit_half);
  return imex_method("user_" + id, tableau.order, 0, "with the tables of odeum/" + id,
                     [implicit, outer, order = tableau.order](void* arkstep) {
                       return ARKStepSetTables(arkstep, order, 0, implicit.get(), outer.get());
                     });
}

}  // namespace

std::vector<Method> arkode_imex_methods() {
  std::vector<Method> list;
  for (const ImplicitTable& table : implicit_tables())
    for (const ExplicitTable& other : explicit_tables()) {
      std::string as_explicit = table.name;
      const std::size_t word = as_explicit.find("_DIRK_");
      if (!table.name.starts_with("ARK") || word == std::string::npos) continue;
      as_explicit.replace(word, 6, "_ERK_");
      if (other.name == as_explicit) list.push_back(built_in_pair(table, other));
    }
  list.push_back(user_pair<methods::ars222>(methods::ars222_tableau));
  list.push_back(user_pair<methods::ars443>(methods::ars443_tableau));
  return list;
}

std::vector<Method> arkode_implicit_methods() {
  std::vector<Method> list;
  for (const ImplicitTable& table : implicit_tables())
    list.push_back(built_in(table, Settings::best));
  list.push_back(ark2());
  // The library's default tables of orders 2 to 5 again, as they come: what the settings gain.
  for (const ImplicitTable& table : implicit_tables())
    for (const int id : {ARKSTEP_DEFAULT_DIRK_2, ARKSTEP_DEFAULT_DIRK_3, ARKSTEP_DEFAULT_DIRK_4,
                         ARKSTEP_DEFAULT_DIRK_5})
      if (table.id == id) list.push_back(built_in(table, Settings::library_default));
  return list;
}

}  // namespace odeum::adapters::sundials
