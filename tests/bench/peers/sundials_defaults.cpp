// SPDX-License-Identifier: BSD-3-Clause
// ARKODE's default tables before and since SUNDIALS 7.3.0 in ARKStep of the release that is linked,
// by counts: a change is what the new table costs beside the old one, and again with the new
// defaults of the step control.
#include <arkode/arkode_arkstep.h>
#include <sundials/sundials_config.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bench/peers/peers.hpp"
#include "odeum/cases/catalogue.hpp"
#include "sundials/arkode.hpp"
#include "sundials/later_tables.hpp"
#include "support/sundials_parts.hpp"

namespace odeum::peers {
namespace {

namespace adapter = adapters::sundials;

struct Problem {
  Counted counted;
  bool split = false;
};

int rhs(double t, N_Vector y, N_Vector f, void* data) {
  return static_cast<Problem*>(data)->counted.rhs(t, NV_DATA_S(y), NV_DATA_S(f)) ? 0 : -1;
}

int part(decltype(OdeView::rhs) f, double t, N_Vector y, N_Vector dydt, void* data) {
  Counted& counted = static_cast<Problem*>(data)->counted;
  f(counted.view.problem, t, NV_DATA_S(y), NV_DATA_S(dydt));
  return ++counted.evaluations <= Counted::most_evaluations ? 0 : -1;
}

int explicit_part(double t, N_Vector y, N_Vector f, void* data) {
  return part(static_cast<Problem*>(data)->counted.view.explicit_part, t, y, f, data);
}

int implicit_part(double t, N_Vector y, N_Vector f, void* data) {
  return part(static_cast<Problem*>(data)->counted.view.implicit_part, t, y, f, data);
}

int jacobian(double t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector,
             N_Vector) {
  const auto& problem = *static_cast<Problem*>(data);
  const OdeView& ode = problem.counted.view;
  const std::size_t n = ode.dimension;
  std::vector<double> rows(n * n);
  (problem.split ? ode.implicit_jacobian : ode.jacobian)(ode.problem, t, NV_DATA_S(y), rows.data());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) SUNDenseMatrix_Data(matrix)[j * n + i] = rows[i * n + j];
  return 0;
}

void silent(int, const char*, const char*, char*, void*) {}

using Set = std::function<void(void* arkstep)>;

enum class Kind { explicit_rk, implicit_rk, additive };

/// A default of an order: its tables before and since.
struct Default {
  Kind kind;
  int order;
  const char *until, *since;
  Set set_until, set_since;
};

Set built_in(ARKODE_DIRKTableID implicit, ARKODE_ERKTableID outer) {
  return [=](void* m) { ARKStepSetTableNum(m, implicit, outer); };
}
Set erk(ARKODE_ERKTableID id) { return built_in(ARKODE_DIRK_NONE, id); }
Set dirk(ARKODE_DIRKTableID id) { return built_in(id, ARKODE_ERK_NONE); }

template <std::size_t S>
Set user(const Tableau<S>& tableau) {
  std::shared_ptr<ARKodeButcherTableMem> table = adapter::as_butcher_table(tableau);
  return [table, outer = tableau.is_explicit()](void* m) {
    ARKStepSetTables(m, table->q, table->p, outer ? nullptr : table.get(),
                     outer ? table.get() : nullptr);
  };
}

std::vector<Default> defaults() {
  using enum Kind;
  return {{explicit_rk, 2, "HEUN_EULER_2_1_2", "RALSTON_3_1_2", erk(ARKODE_HEUN_EULER_2_1_2),
           user(adapter::ralston_3_1_2)},
          {explicit_rk, 4, "ZONNEVELD_5_3_4", "SOFRONIOU_SPALETTA_5_3_4",
           erk(ARKODE_ZONNEVELD_5_3_4), user(adapter::sofroniou_spaletta_5_3_4)},
          {explicit_rk, 5, "CASH_KARP_6_4_5", "TSITOURAS_7_4_5", erk(ARKODE_CASH_KARP_6_4_5),
           user(adapter::tsitouras_7_4_5)},
          {explicit_rk, 6, "VERNER_8_5_6", "VERNER_9_5_6", erk(ARKODE_VERNER_8_5_6),
           user(adapter::verner_9_5_6)},
          {explicit_rk, 8, "FEHLBERG_13_7_8", "VERNER_13_7_8", erk(ARKODE_FEHLBERG_13_7_8),
           user(adapter::verner_13_7_8)},
          {implicit_rk, 2, "SDIRK_2_1_2", "ARK2_DIRK_3_1_2", dirk(ARKODE_SDIRK_2_1_2),
           user(adapter::ark2_dirk_3_1_2)},
          {implicit_rk, 3, "ARK324L2SA_DIRK_4_2_3", "ESDIRK325L2SA_5_2_3",
           dirk(ARKODE_ARK324L2SA_DIRK_4_2_3), dirk(ARKODE_ESDIRK325L2SA_5_2_3)},
          {implicit_rk, 4, "SDIRK_5_3_4", "ESDIRK436L2SA_6_3_4", dirk(ARKODE_SDIRK_5_3_4),
           dirk(ARKODE_ESDIRK436L2SA_6_3_4)},
          {implicit_rk, 5, "ARK548L2SA_DIRK_8_4_5", "ESDIRK547L2SA2_7_4_5",
           dirk(ARKODE_ARK548L2SA_DIRK_8_4_5), dirk(ARKODE_ESDIRK547L2SA2_7_4_5)},
          {additive, 4, "ARK436L2SA_6_3_4", "ARK437L2SA_7_3_4",
           built_in(ARKODE_ARK436L2SA_DIRK_6_3_4, ARKODE_ARK436L2SA_ERK_6_3_4),
           built_in(ARKODE_ARK437L2SA_DIRK_7_3_4, ARKODE_ARK437L2SA_ERK_7_3_4)},
          {additive, 5, "ARK548L2SA_8_4_5", "ARK548L2SAb_8_4_5",
           built_in(ARKODE_ARK548L2SA_DIRK_8_4_5, ARKODE_ARK548L2SA_ERK_8_4_5),
           built_in(ARKODE_ARK548L2SAb_DIRK_8_4_5, ARKODE_ARK548L2SAb_ERK_8_4_5)}};
}

/// The defaults of the step control since 7.3.0: an I controller with the exponent 1 / (p + 1) of
/// an embedded row of order p, a safety factor of 0.9, no bias, and no interval of steps that stay.
void set_later_control(void* m) {
  double gains[3] = {1, 0, 0};
  constexpr int by_order_of_method = 1;  // which is p + 1 in each of the tables
  ARKStepSetAdaptivityMethod(m, ARK_ADAPT_I, 0, by_order_of_method, gains);
  ARKStepSetSafetyFactor(m, 0.9);
  ARKStepSetErrorBias(m, 1);
  ARKStepSetFixedStepBounds(m, 1, 1);
}

/// With the settings of Newton's iteration that the adapter takes (reports/peers.md).
Run run(Kind kind, const Set& set, const Case& c, double tolerance, Problem& problem) {
  Run run{.y = c.y0};
  tests::SundialsParts parts(run.y);
  problem.split = kind == Kind::additive;
  const ARKRhsFn outer = kind == Kind::explicit_rk ? rhs
                         : problem.split           ? explicit_part
                                                   : nullptr,
                 inner = kind == Kind::implicit_rk ? rhs
                         : problem.split           ? implicit_part
                                                   : nullptr;
  void* memory = ARKStepCreate(outer, inner, c.t0, parts.y, parts.context);
  ARKStepSetErrHandlerFn(memory, silent, nullptr);
  ARKStepSetUserData(memory, &problem);
  ARKStepSetInterpolantType(memory, ARK_INTERP_LAGRANGE);
  ARKStepSetInterpolantDegree(memory, 1);
  ARKStepSStolerances(memory, tolerance, tolerance);
  set(memory);
  if (kind != Kind::explicit_rk) {
    ARKStepSetLinearSolver(memory, parts.solver, parts.matrix);
    ARKStepSetJacFn(memory, jacobian);
    ARKStepSetLSetupFrequency(memory, -1);
    ARKStepSetDeduceImplicitRhs(memory, 1);
    ARKStepSetPredictorMethod(memory, 1);
  }
  ARKStepSetMaxNumSteps(memory, -1);
  int flag = 0;
  double t = c.t0;
  for (std::size_t k = 0; k < c.stops.size() && flag >= 0; ++k) {
    ARKStepSetStopTime(memory, c.stops[k]);
    flag = ARKStepEvolve(memory, c.stops[k], parts.y, &t, ARK_NORMAL);
  }
  ARKStepFree(&memory);
  run.ok = flag >= 0;
  return run;
}

/// One solver on one case at all tolerances; those that are not solved have an infinite error.
std::vector<Solved> runs_of(Kind kind, const Set& set, const Case& c) {
  std::vector<Solved> all;
  for (const double tolerance : tolerances) {
    Problem problem{.counted = {c.problem.view}};
    const Run made = run(kind, set, c, tolerance, problem);
    const double error = made.ok ? error_at_end(c, made.y) : unreached;
    all.push_back({error < 0.1 ? std::max(error, c.truth.floor) : unreached, 0,
                   static_cast<double>(problem.counted.evaluations)});
  }
  return all;
}

int solved(const std::vector<Solved>& runs) {
  return static_cast<int>(
      std::ranges::count_if(runs, [](const Solved& r) { return r.error != unreached; }));
}

/// A geometric mean of ratios; none: not a number.
struct Mean {
  double sum = 0;
  int count = 0;
  void add(double ratio) { sum += std::log(ratio), ++count; }
  double value() const {
    return count == 0 ? std::numeric_limits<double>::quiet_NaN() : std::exp(sum / count);
  }
};

void add_row(record::Records& table, const Default& d, const char* control, const Case& c,
             const std::vector<Solved>& until, const std::vector<Solved>& since) {
  Mean evaluations, error, to_error;
  for (std::size_t k = 0; k < until.size(); ++k) {
    if (until[k].error == unreached || since[k].error == unreached) continue;
    evaluations.add(since[k].evaluations / until[k].evaluations);
    if (until[k].error > 0 && since[k].error > 0) error.add(since[k].error / until[k].error);
  }
  for (const double wanted : wanted_errors) {
    const double before = cost_of(wanted, until, &Solved::evaluations),
                 after = cost_of(wanted, since, &Solved::evaluations);
    if (std::isfinite(before) && std::isfinite(after)) to_error.add(after / before);
  }
  const auto three = [](double x) {
    return std::isnan(x) ? std::string("nan") : fmt::format("{:.3g}", x);
  };
  constexpr const char* kinds[] = {"explicit", "implicit", "additive"};
  table.rows.push_back({std::string(kinds[static_cast<int>(d.kind)]), static_cast<double>(d.order),
                        std::string(d.until), std::string(d.since), std::string(control),
                        std::string("SUNDIALS " SUNDIALS_VERSION), c.id,
                        static_cast<double>(until.size()), static_cast<double>(solved(until)),
                        static_cast<double>(solved(since)), three(evaluations.value()),
                        three(error.value()), static_cast<double>(to_error.count),
                        three(to_error.value())});
}

bool fits(Kind kind, const Case& c) {
  const OdeView& view = c.problem.view;
  if (!view.rhs || !c.truth.at || c.y0.empty() || c.y0.size() > 64) return false;
  if (kind == Kind::explicit_rk) return c.nature.smooth;
  if (kind == Kind::implicit_rk) return c.nature.stiff && view.jacobian;
  return view.explicit_part && view.implicit_part && view.implicit_jacobian;
}

}  // namespace

record::Records sundials_default_rows() {
  record::Records table{{"type", "order", "until_7_2_1", "since_7_3_0", "step_control", "run_by",
                         "case", "runs", "solved_until", "solved_since", "evaluations", "error",
                         "errors_reached", "evaluations_to_errors"}};
  const auto cases = all_cases();
  for (const Default& d : defaults())
    for (const Case& c : cases) {
      if (!fits(d.kind, c)) continue;
      const std::vector<Solved> until = runs_of(d.kind, d.set_until, c);
      add_row(table, d, "6.4.1", c, until, runs_of(d.kind, d.set_since, c));
      const Set both = [&](void* m) { d.set_since(m), set_later_control(m); };
      add_row(table, d, "7.3.0", c, until, runs_of(d.kind, both, c));
    }
  return table;
}

}  // namespace odeum::peers
