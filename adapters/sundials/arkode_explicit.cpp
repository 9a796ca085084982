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
#include "sundials/arkode.hpp"
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {
namespace {

void create_erkstep(Session& session) {
  session.adopt(ERKStepCreate(Session::rhs, session.t0(), session.y(), session.context()));
  if (session.interpolate_outputs()) return;
  // Nothing is interpolated, see create_arkstep; an interpolant of degree 1 costs no evaluation.
  check(ERKStepSetInterpolantDegree(session.integrator(), 1), "setting the interpolant's degree");
}

/// The library's two steppers for an explicit table.
struct Stepper {
  const char* prefix;  ///< of the solver's name
  const char* title;
  const Module* module;
  void (*create)(Session&);
  int (*use_built_in)(void*, ARKODE_ERKTableID);
  int (*use_table)(void*, ARKodeButcherTable);
};

constexpr Stepper erkstep{.prefix = "erkstep_",
                          .title = "ARKODE ERKStep",
                          .module = &erkstep_module,
                          .create = create_erkstep,
                          .use_built_in = ERKStepSetTableNum,
                          .use_table = ERKStepSetTable};

constexpr Stepper arkstep{
    .prefix = "arkstep_",
    .title = "ARKODE ARKStep, explicit",
    .module = &arkstep_module,
    .create = [](Session& session) { create_arkstep(session, Session::rhs, nullptr); },
    .use_built_in =
        [](void* integrator, ARKODE_ERKTableID id) {
          return ARKStepSetTableNum(integrator, ARKODE_DIRK_NONE, id);
        },
    .use_table =
        [](void* integrator, ARKodeButcherTable table) {
          return ARKStepSetTables(integrator, table->q, table->p, nullptr, table);
        }};

Method built_in(const Stepper& stepper, const ExplicitTable& table) {
  return {describe_table(stepper.prefix + table.method, "explicit_rk", table.order,
                         table.order_embedded,
                         std::string(stepper.title) + ", built-in table ARKODE_" + table.name),
          stepper.module, [&stepper, id = table.id](Session& session) {
            stepper.create(session);
            check(stepper.use_built_in(session.integrator(), id), "setting the table");
          }};
}

/// The library's steppers with the coefficients of an own method.
template <class M, std::size_t S>
Method user(const Stepper& stepper, const Tableau<S>& tableau) {
  const std::string id(M::info.id);
  std::shared_ptr<ARKodeButcherTableMem> table = as_butcher_table(tableau);
  return {describe_table(stepper.prefix + ("user_" + id), "explicit_rk", tableau.order,
                         tableau.order_hat,
                         std::string(stepper.title) + " with the table of odeum/" + id),
          stepper.module, [&stepper, table](Session& session) {
            stepper.create(session);
            check(stepper.use_table(session.integrator(), table.get()), "setting the table");
          }};
}

}  // namespace

std::vector<Method> arkode_explicit_methods() {
  std::vector<Method> list;
  for (const Stepper* stepper : {&erkstep, &arkstep}) {
    for (const ExplicitTable& table : explicit_tables()) list.push_back(built_in(*stepper, table));
    list.push_back(user<methods::explicit_euler>(*stepper, methods::explicit_euler_tableau));
    list.push_back(user<methods::midpoint>(*stepper, methods::midpoint_tableau));
    list.push_back(user<methods::heun>(*stepper, methods::heun_tableau));
    list.push_back(user<methods::rk4>(*stepper, methods::rk4_tableau));
    list.push_back(user<methods::cash_karp54>(*stepper, methods::cash_karp54_tableau));
  }
  return list;
}

}  // namespace odeum::adapters::sundials
