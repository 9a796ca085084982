// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include <cctype>
#include <memory>
#include <string>
#include <utility>

#include "odeum/methods/cash_karp54.hpp"
#include "odeum/methods/explicit_euler.hpp"
#include "odeum/methods/heun.hpp"
#include "odeum/methods/midpoint.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/methods/verner98.hpp"
#include "sundials/arkode.hpp"
#include "sundials/later_tables.hpp"
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
                         std::string(stepper.title) + ", built-in table ARKODE_" + table.name +
                             default_of(table.name)),
          stepper.module, [&stepper, id = table.id](Session& session) {
            stepper.create(session);
            check(stepper.use_built_in(session.integrator(), id), "setting the table");
          }};
}

/// The library's steppers with coefficients of its user. `source` ends "with the table ...".
template <std::size_t S>
Method user(const Stepper& stepper, const Tableau<S>& tableau, std::string name,
            const std::string& source) {
  std::shared_ptr<ARKodeButcherTableMem> table = as_butcher_table(tableau);
  return {
      describe_table(stepper.prefix + ("user_" + std::move(name)), "explicit_rk", tableau.order,
                     tableau.order_hat, std::string(stepper.title) + " with the table " + source),
      stepper.module, [&stepper, table](Session& session) {
        stepper.create(session);
        check(stepper.use_table(session.integrator(), table.get()), "setting the table");
      }};
}

template <class M, std::size_t S>
Method user(const Stepper& stepper, const Tableau<S>& tableau) {
  const std::string id(M::info.id);
  return user(stepper, tableau, id, "of odeum/" + id);
}

/// A table of a later release, by its name there.
template <std::size_t S>
void add_later(std::vector<Method>& list, const Stepper& stepper, const Tableau<S>& tableau,
               const std::string& name) {
  // ERKStep takes a last node at 1 for first same as last (reports/findings/sundials.md): other
  // tables lose their order in it, until the release that mends it.
  if (&stepper == &erkstep && !tableau.first_same_as_last()) return;
  std::string method = name;
  for (char& c : method) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  list.push_back(
      user(stepper, tableau, method, "ARKODE_" + name + " of SUNDIALS 7.3.0" + default_of(name)));
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
    add_later(list, *stepper, ralston_3_1_2, "RALSTON_3_1_2");
    add_later(list, *stepper, sofroniou_spaletta_5_3_4, "SOFRONIOU_SPALETTA_5_3_4");
    add_later(list, *stepper, tsitouras_7_4_5, "TSITOURAS_7_4_5");
    add_later(list, *stepper, verner_9_5_6, "VERNER_9_5_6");
    add_later(list, *stepper, verner_10_6_7, "VERNER_10_6_7");
    add_later(list, *stepper, verner_13_7_8, "VERNER_13_7_8");
    add_later(list, *stepper, methods::verner98_tableau, "VERNER_16_8_9");
  }
  return list;
}

}  // namespace odeum::adapters::sundials
