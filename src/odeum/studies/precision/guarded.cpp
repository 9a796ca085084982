// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/timing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/core/numbers.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/studies/foreseen.hpp"

namespace odeum::study {
namespace {

std::vector<Request> settings_of(const TimedCase& stage, Mode mode, double seconds) {
  std::vector<Request> requests;
  Request request;
  request.stops = stage.stops;
  request.budget.evaluations = stage.c.settings.evaluation_budget;
  const bool many = stage.c.y0.size() > dense_dimension_limit;
  request.budget.evaluations =
      many ? request.budget.evaluations / 8
           : std::min<std::uint64_t>(
                 400'000, static_cast<std::uint64_t>(
                              stage.stretch() * static_cast<double>(request.budget.evaluations)));
  request.budget.seconds = seconds;
  request.mode = mode;
  if (mode == Mode::adaptive) {
    // Errors grow along a long horizon: the smallest reachable error needs tolerances near
    // rounding.
    const int finest = stage.stretch() > 1 ? 14 : 12;
    return tolerance_ladder(request, stage.c, finest);
  }
  const double coarsest = static_cast<double>(stage.c.settings.coarsest_steps) * stage.stretch();
  for (int k = 0; k < 8; ++k) {
    const auto units =
        std::ceil(std::ldexp(coarsest, k) / static_cast<double>(stage.c.settings.steps_multiple));
    request.steps = static_cast<std::uint64_t>(units) * stage.c.settings.steps_multiple;
    requests.push_back(request);
  }
  return requests;
}

PrecisionRow blank_row(const TimedCase& stage, const SolverInfo& info, Mode mode) {
  auto row = named_row<PrecisionRow>(stage.c, info);
  row.mode = mode;
  row.jacobian = jacobian_of(stage.c);
  return row;
}

std::string text_of_options(const Variant& options) {
  std::string text;
  for (const auto& [name, value] : options)
    text += fmt::format("{}{}={:g}", text.empty() ? "" : " ", name, value);
  return text;
}

std::string absolute_of(const Request& request) {
  if (request.mode == Mode::fixed) return {};
  const Tolerance& tolerance = request.tolerance;
  if (tolerance.absolutes().empty()) return fmt::format("{:g}", tolerance.relative);
  return fmt::format("{:g}", fmt::join(tolerance.absolutes(), " "));
}

TimedRun blank_run(const TimedCase& stage, const Entrant& entrant, const Request& request) {
  TimedRun trial{.row = blank_row(stage, entrant.info, request.mode),
                 .request = request,
                 .states = {},
                 .times = {}};
  trial.row.setting = setting_of(request, stage.c.t0);
  trial.row.absolute = absolute_of(request);
  trial.row.options = text_of_options(request.options);
  trial.row.judged.answer = judge::Answer::none;
  return trial;
}

/// Tolerances looser than the first, up to 1e-1, while that still reaches the largest error
/// compared: a solver that is more accurate than its tolerance gets there by a looser one.
void run_looser(const TimedCase& stage, TimedSolver& solver) {
  for (int more = 0; more < 2; ++more) {
    const TimedRun& coarsest = solver.trials.front();
    if (!coarsest.ok() || !(coarsest.row.error < compared_errors().front())) return;
    Request request = coarsest.request;
    set_tolerance(request, stage.c, 10 * request.tolerance.relative);
    TimedRun looser = run_guarded(stage, *solver.entrant, request);
    solver.trials.insert(solver.trials.begin(), std::move(looser));
  }
}

}  // namespace

TimedRun run_guarded(const TimedCase& stage, const Entrant& entrant, const Request& request) {
  TimedRun trial = blank_run(stage, entrant, request);
  const double start = thread_seconds();
  Outcome outcome = entrant.solve(request);
  trial.guarded_ns = 1e9 * (thread_seconds() - start);
  trial.row.take(stage.c, entrant.info, request, outcome);
  trial.status = outcome.status;
  if (!trial.ok()) return trial;
  const std::vector<judge::StopError> errors = stage.judge.errors(outcome);
  trial.row.take_errors(errors);
  trial.row.judged = measure::answer_of(request, outcome, errors, stage.amplification, stage.floor,
                                        stage.judge.scale());
  if (trial.row.error <= stage.floor) trial.row.detail = "at the truth's floor";
  trial.states = std::move(outcome.states);
  return trial;
}

void run_guarded(const TimedCase& stage, TimedSolver& solver, double seconds) {
  const Entrant& entrant = *solver.entrant;
  const std::string& reason = entrant.unfit.empty() && solver.mode == Mode::fixed
                                  ? stage.c.settings.no_fixed_steps
                                  : entrant.unfit;
  if (!reason.empty()) {
    solver.trials.emplace_back().row =
        not_applicable(blank_row(stage, entrant.info, solver.mode), reason);
    return;
  }
  Foreseen foreseen;
  for (Request request : settings_of(stage, solver.mode, seconds)) {
    request.options = solver.options;
    if (const std::string excess = foreseen.excess(request); !excess.empty()) {
      solver.trials.push_back(blank_run(stage, entrant, request));
      solver.trials.back().row.status = to_string(Status::over_budget);
      solver.trials.back().row.detail = excess;
      break;
    }
    solver.trials.push_back(run_guarded(stage, entrant, request));
    if (const TimedRun& run = solver.trials.back(); run.ok())
      foreseen.add(run.request, run.row.counters.work, run.guarded_ns);
    // Finer settings cost more and are not needed.
    if (solver.trials.back().row.status == to_string(Status::over_budget)) break;
  }
  if (solver.mode == Mode::adaptive) run_looser(stage, solver);
}

void run_beyond_budget(const TimedCase& stage, std::vector<TimedSolver>& solvers,
                       const Runner& runner, double seconds) {
  std::set<std::string> solved;
  for (const TimedSolver& solver : solvers)
    for (const TimedRun& trial : solver.trials)
      if (trial.ok()) solved.insert(trial.row.library);
  parallel_for(solvers.size(), runner.jobs(), [&](std::size_t i) {
    TimedSolver& solver = solvers[i];
    if (solver.trials.empty() || solver.trials.front().row.status != to_string(Status::over_budget))
      return;
    TimedRun& loosest = solver.trials.front();
    if (solver.mode != Mode::adaptive || solved.contains(loosest.row.library)) return;
    Request request = loosest.request;
    request.budget.evaluations = 30 * stage.c.settings.evaluation_budget;
    request.budget.seconds = 5 * seconds;
    loosest = run_guarded(stage, *solver.entrant, request);
    if (loosest.ok()) loosest.row.detail = "beyond the budget of the other solvers";
  });
}

}  // namespace odeum::study
