// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include <memory>
#include <utility>

#include "odeum/methods/cash_karp54.hpp"
#include "odeum/methods/explicit_euler.hpp"
#include "odeum/methods/heun.hpp"
#include "odeum/methods/midpoint.hpp"
#include "odeum/methods/rk4.hpp"
#include "sundials/arkode_tables.hpp"
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {
namespace {

// Every stop is a step's end, so nothing is interpolated: the lowest degree spares the evaluations
// and vectors that the interpolant would else take.
constexpr int interpolant_degree = 1;

void create_erkstep(Session& session) {
  session.adopt(ERKStepCreate(Session::rhs, session.t0(), session.y(), session.context()));
  check(ERKStepSetInterpolantDegree(session.integrator(), interpolant_degree),
        "setting the interpolant's degree");
}

Method erkstep(const ExplicitTable& table) {
  return {
      describe_table("erkstep_" + table.method, "explicit_rk", table.order, table.order_embedded,
                     "ARKODE ERKStep, built-in table ARKODE_" + table.name),
      &erkstep_module, [id = table.id](Session& session) {
        create_erkstep(session);
        check(ERKStepSetTableNum(session.integrator(), id), "setting the table");
      }};
}

Method arkstep(const ExplicitTable& table) {
  return {
      describe_table("arkstep_" + table.method, "explicit_rk", table.order, table.order_embedded,
                     "ARKODE ARKStep, explicit, built-in table ARKODE_" + table.name),
      &arkstep_module, [id = table.id](Session& session) {
        session.adopt(
            ARKStepCreate(Session::rhs, nullptr, session.t0(), session.y(), session.context()));
        void* const integrator = session.integrator();
        check(ARKStepSetInterpolantDegree(integrator, interpolant_degree),
              "setting the interpolant's degree");
        check(ARKStepSetTableNum(integrator, ARKODE_DIRK_NONE, id), "setting the table");
      }};
}

/// The library's stepping with an own method's coefficients.
template <class M, std::size_t S>
Method erkstep_user(const Tableau<S>& tableau) {
  std::shared_ptr<ARKodeButcherTableMem> table = as_butcher_table(tableau);
  return {describe_table("erkstep_user_" + std::string(M::info.id), "explicit_rk", tableau.order,
                         tableau.order_hat,
                         "ARKODE ERKStep with the table of odeum/" + std::string(M::info.id)),
          &erkstep_module, [table](Session& session) {
            create_erkstep(session);
            check(ERKStepSetTable(session.integrator(), table.get()), "setting the table");
          }};
}

}  // namespace

std::vector<Method> arkode_explicit_methods() {
  std::vector<Method> list;
  for (const ExplicitTable& table : explicit_tables()) list.push_back(erkstep(table));
  for (const ExplicitTable& table : explicit_tables()) list.push_back(arkstep(table));
  list.push_back(erkstep_user<methods::explicit_euler>(methods::explicit_euler_tableau));
  list.push_back(erkstep_user<methods::midpoint>(methods::midpoint_tableau));
  list.push_back(erkstep_user<methods::heun>(methods::heun_tableau));
  list.push_back(erkstep_user<methods::rk4>(methods::rk4_tableau));
  list.push_back(erkstep_user<methods::cash_karp54>(methods::cash_karp54_tableau));
  return list;
}

}  // namespace odeum::adapters::sundials
