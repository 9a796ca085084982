// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/study/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/harness/glob.hpp"
#include "odeum/harness/parallel.hpp"
#include "odeum/harness/progress.hpp"
#include "odeum/study/judge.hpp"
#include "odeum/study/pair_result.hpp"
#include "odeum/study/settings.hpp"

namespace odeum::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double claimed_order(const Pair& pair) {
  const SolverInfo& info = pair.entrant->info;
  return pair.mode == Mode::adaptive && info.adaptive_order ? nan : info.order;
}

ConvergenceRow make_row(const Pair& pair, const Request& request, const Outcome& outcome) {
  ConvergenceRow row;
  row.case_id = pair.c->id;
  row.library = pair.entrant->info.library;
  row.solver = pair.entrant->info.method;
  row.mode = pair.mode;
  row.status = to_string(outcome.status);
  row.detail = outcome.detail;
  row.counters = outcome.counters;
  const double horizon = request.stops.back() - pair.c->t0;
  if (pair.mode == Mode::fixed) {
    row.steps = request.steps;
    row.step = horizon / static_cast<double>(request.steps);
    row.tolerance = nan;
  } else {
    row.steps = outcome.counters.steps;
    row.step =
        outcome.status == Status::ok && row.steps ? horizon / static_cast<double>(row.steps) : nan;
    row.tolerance = request.tolerance;
  }
  row.error_max = row.error_rms = row.energy_error = nan;
  return row;
}

void judge_row(const std::vector<StopError>& errors, ConvergenceRow& row) {
  row.error_max = row.error_rms = 0;
  row.energy_error = std::isnan(errors.front().energy) ? nan : 0;
  for (const StopError& error : errors) {
    row.error_max = std::max(row.error_max, error.error_max);
    row.error_rms += error.error_rms * error.error_rms / static_cast<double>(errors.size());
    if (!(error.energy_error <= row.energy_error)) row.energy_error = error.energy_error;
  }
  row.error_rms = std::sqrt(row.error_rms);
}

/// Why there is nothing to measure; empty: there is.
const std::string& reason_against(const Pair& pair) {
  if (!pair.entrant->unfit.empty()) return pair.entrant->unfit;
  if (!pair.c->no_convergence.empty()) return pair.c->no_convergence;
  static const std::string none;
  return pair.mode == Mode::fixed ? pair.c->no_fixed_steps : none;
}

PairResult not_applicable(const Pair& pair) {
  PairResult result;
  ConvergenceRow row = make_row(pair, {.steps = 1, .stops = {nan}}, {});
  row.status = "not_applicable";
  row.detail = reason_against(pair);
  row.steps = 0;
  row.step = row.tolerance = nan;
  result.rows.push_back(row);
  result.order.fit.verdict = Verdict::not_applicable;
  result.order.fit.reason = row.detail;
  return result;
}

PairResult run_pair(const Pair& pair, const Judge& judge, bool quick) {
  if (!reason_against(pair).empty()) return not_applicable(pair);
  PairResult result;
  std::vector<ErrorPoint> points;
  int at_floor = 0;
  std::vector<Cost> costs;
  for (const Request& request : convergence_settings(pair, quick)) {
    const double foreseen = foreseen_work(costs, request);
    Outcome outcome;
    if (!result.rows.empty() && result.rows.back().status == to_string(Status::over_budget)) {
      outcome.status = Status::over_budget;
      outcome.detail = "not run: a coarser setting was over budget already";
    } else if (foreseen > static_cast<double>(request.budget.evaluations)) {
      outcome.status = Status::over_budget;
      outcome.detail = fmt::format(
          "not run: coarser settings say that it takes more than {} evaluations and products",
          request.budget.evaluations);
    } else {
      outcome = pair.entrant->solve(request);
    }
    if (outcome.status == Status::ok)
      costs.push_back(
          {pair.mode == Mode::fixed ? static_cast<double>(request.steps) : 1 / request.tolerance,
           static_cast<double>(outcome.counters.work)});
    ConvergenceRow row = make_row(pair, request, outcome);
    ErrorPoint point{.step = row.step, .error = nan};
    if (outcome.status == Status::ok) {
      const std::vector<StopError> errors = judge.errors(outcome);
      judge_row(errors, row);
      for (const StopError& e : errors)
        result.times.push_back({row.case_id, row.library, row.solver, row.mode, row.step, e.time,
                                e.error_max, e.error_rms, e.energy, e.energy_error});
      point.error = row.error_max;
      point.rounding_unit = judge.rounding_unit();
      point.floor = pair.c->truth.floor;
      point.steps = static_cast<double>(row.steps);
      at_floor = point.error <= point.typical_rounding() ? at_floor + 1 : 0;
    }
    points.push_back(point);
    result.rows.push_back(std::move(row));
    // Rounding alone is left to see: eight settings are on record, finer ones would only repeat it.
    if (at_floor >= 3 && result.rows.size() >= 8) break;
  }
  const double claimed = claimed_order(pair);
  result.order.fit = fit_order(
      points, claimed,
      pair.mode == Mode::fixed ? fixed_step_tolerance(claimed) : adaptive_tolerance(claimed));
  if (result.order.fit.verdict == Verdict::failed)
    result.order.fit.reason += ": " + result.rows.back().status + ", " + result.rows.back().detail;
  return result;
}

// Who a row is of does not stand in the record: the pair says it.
void sign(const Pair& pair, PairResult& result) {
  const auto mark = [&](auto& row) {
    row.case_id = pair.c->id;
    row.library = pair.entrant->info.library;
    row.solver = pair.entrant->info.method;
    row.mode = pair.mode;
  };
  for (ConvergenceRow& row : result.rows) mark(row);
  for (TimeRow& row : result.times) mark(row);
  mark(result.order);
  result.order.claimed_order = claimed_order(pair);
}

std::vector<Pair> select_pairs(const ConvergenceOptions& options) {
  std::vector<Pair> pairs;
  for (const Case& c : all_cases()) {
    if (!any_glob_matches(options.cases, c.id)) continue;
    for (const Entrant& entrant : c.entrants) {
      if (!any_glob_matches(options.solvers, entrant.info.id())) continue;
      for (const Mode mode : {Mode::fixed, Mode::adaptive}) {
        const bool offered = mode == Mode::fixed ? entrant.info.fixed : entrant.info.adaptive;
        const bool wanted =
            options.modes.empty() || std::count(options.modes.begin(), options.modes.end(), mode);
        if (offered && wanted) pairs.push_back({&c, &entrant, mode});
      }
    }
  }
  return pairs;
}

}  // namespace

ConvergenceResult converge(const ConvergenceOptions& options, report::Journal* journal) {
  const std::vector<Pair> pairs = select_pairs(options);
  std::vector<PairResult> results(pairs.size());
  Progress progress("converge", static_cast<double>(pairs.size()));
  parallel_for(pairs.size(), options.jobs, [&](std::size_t i) {
    const Pair& pair = pairs[i];
    const std::string key = pair.c->id + ' ' + pair.entrant->info.id() + ' ' + to_string(pair.mode);
    if (const auto held = journal ? journal->find(key) : std::nullopt) {
      results[i] = read_record(*held);
    } else {
      results[i] = run_pair(pair, Judge(*pair.c, pair.c->stops), options.quick);
      if (journal && !interrupted) journal->add(key, write_record(results[i]));
    }
    sign(pair, results[i]);
    progress.advance();
  });
  ConvergenceResult all;
  for (PairResult& result : results) {
    std::move(result.rows.begin(), result.rows.end(), std::back_inserter(all.rows));
    std::move(result.times.begin(), result.times.end(), std::back_inserter(all.times));
    all.orders.push_back(std::move(result.order));
  }
  return all;
}

}  // namespace odeum::study
