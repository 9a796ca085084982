// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/study/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/harness/glob.hpp"
#include "odeum/harness/parallel.hpp"
#include "odeum/harness/progress.hpp"
#include "odeum/study/judge.hpp"
#include "odeum/study/record.hpp"

namespace odeum::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// One solver on one case in one mode: the unit of work, and of the journal.
struct Pair {
  const Case* c;
  const Entrant* entrant;
  Mode mode;
};

double claimed_order(const Pair& pair) {
  const SolverInfo& info = pair.entrant->info;
  return pair.mode == Mode::adaptive && info.adaptive_order ? nan : info.order;
}

struct PairResult {
  std::vector<ConvergenceRow> rows;
  std::vector<TimeRow> times;
  OrderRow order;
};

// Orders are seen on the smooth cases and on the cloths. The hard ones show who gets there at all:
// eight settings and a small budget do, and leave a full report its five minutes.
bool shows_orders(const Case& c) { return c.has_tag("smooth") || c.has_tag("cloth"); }
constexpr std::uint64_t hard_budget = 10'000;

// Step counts from coarse to fine. A factor of two between steps shows a low order well; a high
// one falls to rounding within a few halvings, so its steps lie closer together, and start coarser.
std::vector<std::uint64_t> step_ladder(const Case& c, double order, bool quick) {
  const double p = std::isnan(order) ? 2 : order;
  const double ratio = p <= 2 ? 2 : p <= 4 ? std::sqrt(2.0) : std::cbrt(2.0);
  const int count = p <= 2 ? 11 : p <= 4 ? 16 : 20;
  const double start = static_cast<double>(c.coarsest_steps) / (p <= 4 ? 1 : 2);
  std::vector<std::uint64_t> ladder;
  for (int k = 0; k < count; ++k) {
    const double wanted = start * std::pow(ratio, k);
    if (quick && p > 2 && k % 2 == 1) continue;
    const auto units = std::llround(wanted / static_cast<double>(c.steps_multiple));
    const std::uint64_t steps = static_cast<std::uint64_t>(std::max(units, 1LL)) * c.steps_multiple;
    if (steps > c.finest_steps && ladder.size() >= 8) break;
    if (ladder.empty() || steps > ladder.back()) ladder.push_back(steps);
  }
  const std::size_t most = quick ? 6 : shows_orders(c) ? ladder.size() : 8;
  if (ladder.size() > most) ladder.resize(most);
  return ladder;
}

std::vector<Request> requests_for(const Pair& pair, bool quick) {
  std::vector<Request> requests;
  Request request;
  request.mode = pair.mode;
  request.stops = pair.c->stops;
  request.budget = pair.c->budget_for(pair.entrant->info);
  const bool many = pair.c->y0.size() > dense_dimension_limit;
  if (!shows_orders(*pair.c))
    request.budget.evaluations = std::min(request.budget.evaluations, hard_budget);
  if (quick) request.budget.evaluations /= many ? 32 : 8;
  if (pair.mode == Mode::fixed) {
    for (const std::uint64_t steps : step_ladder(*pair.c, pair.entrant->info.order, quick)) {
      request.steps = steps;
      requests.push_back(request);
    }
  } else {
    const int finest = quick ? 8 : many || !shows_orders(*pair.c) ? 10 : 12;
    for (int exponent = 3; exponent <= finest; ++exponent) {
      request.tolerance = std::pow(10.0, -exponent);
      requests.push_back(request);
    }
  }
  return requests;
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
  for (const Request& request : requests_for(pair, quick)) {
    Outcome outcome;
    if (!result.rows.empty() && result.rows.back().status == to_string(Status::over_budget)) {
      outcome.status = Status::over_budget;
      outcome.detail = "not run: a coarser setting was over budget already";
    } else {
      outcome = pair.entrant->solve(request);
    }
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

// The journal's form of a pair's result.
template <class Record, class Row>
void fields(Record& record, Row& row) requires requires {
  row.counters;
}
{
  record.field(row.status);
  record.field(row.detail);
  record.field(row.step);
  record.field(row.tolerance);
  record.field(row.steps);
  record.field(row.error_max);
  record.field(row.error_rms);
  record.field(row.energy_error);
  record.field(row.counters.steps);
  record.field(row.counters.rejected_steps);
  record.field(row.counters.rhs_evaluations);
  record.field(row.counters.jacobian_evaluations);
}
template <class Record, class Row>
void fields(Record& record, Row& row) requires requires {
  row.energy;
}
{
  record.field(row.step);
  record.field(row.time);
  record.field(row.error_max);
  record.field(row.error_rms);
  record.field(row.energy);
  record.field(row.energy_error);
}
template <class Record, class Fit>
void fit_fields(Record& record, Fit& fit) {
  record.field(fit.reason);
  record.field(fit.order);
  record.field(fit.low);
  record.field(fit.high);
  record.field(fit.points);
  record.field(fit.step_coarsest);
  record.field(fit.step_finest);
  record.field(fit.floor);
}

std::string write_record(const PairResult& result) {
  RecordWriter record;
  record.field(static_cast<int>(result.order.fit.verdict));
  fit_fields(record, result.order.fit);
  record.field(result.rows.size());
  for (const ConvergenceRow& row : result.rows) fields(record, row);
  record.field(result.times.size());
  for (const TimeRow& row : result.times) fields(record, row);
  return record.text();
}

PairResult read_record(const std::string& text) {
  RecordReader record(text);
  PairResult result;
  int verdict = 0;
  record.field(verdict);
  result.order.fit.verdict = static_cast<Verdict>(verdict);
  fit_fields(record, result.order.fit);
  std::size_t count = 0;
  record.field(count);
  for (; count > 0; --count) fields(record, result.rows.emplace_back());
  record.field(count);
  for (; count > 0; --count) fields(record, result.times.emplace_back());
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
