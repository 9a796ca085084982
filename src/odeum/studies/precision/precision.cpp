// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/precision.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "odeum/core/glob.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/solvers/inlined.hpp"
#include "odeum/solvers/variants.hpp"
#include "odeum/studies/precision/timing.hpp"

namespace odeum::study {
namespace {

/// The options that a solver is run with: its defaults and the variants of its library.
std::vector<Variant> tunings_of(const Entrant& entrant) {
  std::vector<Variant> tunings{{}};
  if (entrant.unfit.empty())
    for (const Variant& variant : variants_of(entrant.info.id())) tunings.push_back(variant);
  return tunings;
}

/// Whether a solver is timed in a mode. One that has both is run at fixed steps too where these may
/// be faster: on smooth problems of few unknowns, and on those of many, where explicit methods at
/// their largest stable step may be fastest on stiff ones too.
bool runs(const Case& c, const SolverInfo& info, Mode mode) {
  if (mode == Mode::adaptive) return info.adaptive;
  const bool worth =
      c.settings.no_fixed_steps.empty() && (c.y0.size() > dense_dimension_limit || !c.nature.stiff);
  return info.fixed && (!info.adaptive || worth);
}

/// How often the settings of solvers are searched and timed: where the first found are slower than
/// they promised, others may be faster.
constexpr int most_searches = 3;

std::vector<PrecisionRow> measure_case(const TimedCase& stage, const Options& options,
                                       const Runner& runner) {
  const Case& c = stage.c;
  const std::vector<Entrant> inlined = inlined_solvers(c);
  std::vector<TimedSolver> solvers;
  for (const Entrant& entrant : c.entrants) {
    const std::string id = entrant.info.id();
    if (!any_glob_matches(options.solvers, id)) continue;
    const auto same =
        std::ranges::find_if(inlined, [&](const Entrant& e) { return e.info.id() == id; });
    for (const Mode mode : {Mode::adaptive, Mode::fixed})
      if (runs(c, entrant.info, mode))
        for (const auto& tuning : tunings_of(entrant))
          solvers.push_back({&entrant, mode, same == inlined.end() ? nullptr : &*same, tuning});
  }
  const double most_seconds = options.number(solve_seconds);
  parallel_for(solvers.size(), runner.jobs(),
               [&](std::size_t i) { run_guarded(stage, solvers[i], most_seconds); });
  run_beyond_budget(stage, solvers, runner, most_seconds);

  Conditions conditions;
  for (int attempt = 0; attempt < options.number(most_attempts); ++attempt) {
    for (TimedSolver& solver : solvers)
      for (TimedRun& trial : solver.trials) {
        trial.times.ns.clear();
        trial.done = false;
      }
    const ConditionsMeter meter;
    time_all(stage, solvers, options.number(timed_seconds), runner.jobs());
    for (int more = 0; more < most_searches; ++more)
      if (settle_errors(stage, solvers, runner.jobs()))
        time_all(stage, solvers, options.number(timed_seconds) / most_searches, runner.jobs());
    check_fastest(stage, solvers, runner.jobs());
    conditions = meter.end();
    if (!disturbed(conditions)) break;
  }
  const std::string processor = cpu_model();
  std::vector<PrecisionRow> rows;
  for (TimedSolver& solver : solvers)
    for (TimedRun& trial : solver.trials) {
      PrecisionRow& row = trial.row;
      row.processor = processor;
      row.measured = conditions.measured;
      if (row.repetitions && !trial.guarded()) static_cast<Conditions&>(row) = conditions;
      if (disturbed(row))
        remark(row, fmt::format("disturbed: the machine's speed drifted by {:.0f} %, and the timed "
                                "runs had the processor for {:.0f} % of the time",
                                100 * row.drift, 100 * row.processor_share));
      rows.push_back(std::move(row));
    }
  mark_pareto(rows);
  return rows;
}

/// The rows of methods, without those of closed forms.
std::vector<PrecisionRow> methods_of(const Case& c, std::vector<PrecisionRow> rows) {
  std::erase_if(rows, [&](const PrecisionRow& row) {
    return find_solver(c.entrants, row.library + "/" + row.solver).info.closed_form();
  });
  return rows;
}

}  // namespace

std::string jacobian_of(const Case& c) {
  const OdeView& view = c.problem.view;
  if (view.jacobian || view.jacobian_entries) return "exact";
  return view.jacobian_times ? "products" : "differenced";
}

PrecisionResult measure_precision(const Options& options, const Runner& runner) {
  const std::vector<const Case*> cases = select_cases(options.cases);
  const auto id = [](const Case* c) { return c->id; };
  return runner.run_in_turn("precision", cases, id, [&](const Case* c) {
    PrecisionResult result;
    const TimedCase stage(*c);
    result.rows = measure_case(stage, options, runner);
    result.outputs = measure_outputs(stage, options, runner.jobs());
    for (const PrecisionRow& row : result.rows)
      if (row.mode == Mode::adaptive && row.status == to_string(Status::ok))
        result.tolerances.push_back(
            {row.case_id, row.library, row.solver, row.setting, row.error, row.judged.answer});
    const std::vector<PrecisionRow> compared = methods_of(*c, result.rows);
    result.summary = summarise(compared, c->timed_floor());
    result.fastest = fastest(compared, c->timed_floor());
    return result;
  });
}

}  // namespace odeum::study
