// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <set>

#include "odeum/core/glob.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/studies/precision/timing.hpp"

namespace odeum::study {
namespace {

constexpr std::size_t times_between = 100;

/// Times at equal distances, and those at which errors are measured anyhow.
std::vector<double> output_times(const TimedCase& stage) {
  const double t0 = stage.c.t0, end = stage.stops.back();
  std::set<double> times(stage.stops.begin(), stage.stops.end());
  for (std::size_t k = 1; k < times_between; ++k)
    times.insert(t0 + (end - t0) * static_cast<double>(k) / times_between);
  return {times.begin(), times.end()};
}

OutputRow run_both(const TimedCase& stage, const Entrant& entrant, const judge::Judge& judge,
                   Request request) {
  auto row = named_row<OutputRow>(stage.c, entrant.info);
  row.status = to_string(Status::ok);
  row.tolerance = request.tolerance.relative;
  row.outputs = request.stops.size();
  for (const bool between : {false, true}) {
    request.over_stops = between;
    const Outcome outcome = entrant.solve(request);
    (between ? row.steps_between : row.steps_ends) = outcome.counters.steps;
    (between ? row.work_between : row.work_ends) = outcome.counters.work;
    if (outcome.status == Status::ok) {
      (between ? row.error_between : row.error_ends) =
          judge::over_stops(judge.errors(outcome)).error_max;
    } else {
      row.status = to_string(outcome.status);
      row.detail = (between ? "between the steps: " : "at their ends: ") + outcome.detail;
    }
  }
  return row;
}

}  // namespace

std::vector<OutputRow> measure_outputs(const TimedCase& stage, const Options& options,
                                       unsigned jobs) {
  Request request;
  request.mode = Mode::adaptive;
  request.stops = output_times(stage);
  request.budget.evaluations = stage.c.settings.evaluation_budget;
  request.budget.seconds = options.number(solve_seconds);
  set_tolerance(request, stage.c, 1e-6);
  std::vector<const Entrant*> entrants;
  for (const Entrant& entrant : stage.c.entrants)
    if (entrant.unfit.empty() && entrant.info.adaptive && !entrant.info.closed_form() &&
        any_glob_matches(options.solvers, entrant.info.id()))
      entrants.push_back(&entrant);
  const judge::Judge judge(stage.c, request.stops);
  std::vector<OutputRow> rows(entrants.size());
  parallel_for(rows.size(), jobs,
               [&](std::size_t i) { rows[i] = run_both(stage, *entrants[i], judge, request); });
  return rows;
}

}  // namespace odeum::study
