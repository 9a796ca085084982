// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/pair_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/studies/convergence/extended_order.hpp"
#include "odeum/studies/convergence/order_reason.hpp"
#include "odeum/studies/convergence/settings.hpp"

namespace odeum::study {
namespace {

constexpr double half_unit = std::numeric_limits<double>::epsilon() / 2;

template <class Row>
Row blank_row(const Pair& pair) {
  auto row = named_row<Row>(*pair.c, pair.entrant->info);
  row.mode = pair.mode;
  return row;
}

OrderRow make_order(const Pair& pair, const judge::OrderFit& fit) {
  auto row = blank_row<OrderRow>(pair);
  row.claimed_order = claimed_order(pair);
  row.fit = fit;
  return row;
}

ConvergenceRow make_row(const Pair& pair, const Request& request, const Outcome& outcome) {
  ConvergenceRow row;
  row.take(*pair.c, pair.entrant->info, request, outcome);
  const bool fixed = pair.mode == Mode::fixed;
  row.steps = fixed ? request.steps : outcome.counters.steps;
  if (fixed || (row.ok() && row.steps))
    row.step = (request.stops.back() - pair.c->t0) / static_cast<double>(row.steps);
  return row;
}

/// The runs of one pair.
class PairRuns {
 public:
  PairRuns(const Pair& pair, const CaseMeasures& measures)
      : pair_(pair),
        amplification_(measures.amplification),
        judge_(*pair.c, convergence_stops(*pair.c)),
        rounding_unit_(measures.gain * half_unit * pair.entrant->info.rounding) {}

  /// Runs from coarse to fine, until errors are rounding.
  void run_until_rounding(const std::vector<Request>& requests) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Request& request : requests) {
      runs_.push_back(measure(request, run_unless_over_budget(request)));
      const judge::ErrorPoint& point = runs_.back().point;
      const bool falls = point.error < 0.5 * smallest;
      at_floor_ = near_rounding(point) && !falls ? at_floor_ + 1 : 0;
      if (std::isfinite(point.error)) smallest = std::min(smallest, point.error);
      // With eight settings recorded, finer ones add nothing.
      if (at_floor_ >= 3 && runs_.size() >= 8) break;
    }
  }

  /// Runs extra settings where the order is open: finer steps until errors are rounding, else
  /// steps between those run.
  void run_extra_settings(const Request& like) {
    if (pair_.mode == Mode::adaptive) return run_extra_tolerances(like);
    if (order_is_open() && at_floor_ == 0)
      run_between(settings_beyond(pair_, like, informative_step_counts()), true);
    if (order_is_open())
      run_between(settings_between(pair_, like, informative_step_counts(), at_floor_ > 0), false);
  }

  std::uint64_t steps_of_least_error() const { return run_of_least_error()->row.steps; }

  judge::OrderFit fit() const {
    if (judge_.solution_ends()) {
      judge::OrderFit none;
      none.verdict = judge::Verdict::not_applicable;
      none.reason = "the solution ends before the last stop, where no error falls";
      return none;
    }
    std::vector<judge::ErrorPoint> points;
    for (const Run& run : runs_) points.push_back(run.point);
    const double claimed = claimed_order(pair_);
    judge::OrderFit fit =
        judge::fit_order(points, claimed,
                         pair_.mode == Mode::fixed ? judge::fixed_step_tolerance(claimed)
                                                   : judge::adaptive_tolerance(claimed));
    std::vector<const ConvergenceRow*> rows;
    for (const Run& run : runs_) rows.push_back(&run.row);
    explain(pair_, rows, foreseen_, fit);
    return fit;
  }

  ConvergenceResult result() && {
    ConvergenceResult result;
    result.orders.push_back(make_order(pair_, fit()));
    for (Run& run : runs_) {
      result.rows.push_back(std::move(run.row));
      std::move(run.times.begin(), run.times.end(), std::back_inserter(result.times));
    }
    return result;
  }

 private:
  /// Runs to tolerances between those run, and beyond them until errors are rounding.
  void run_extra_tolerances(const Request& like) {
    const auto is_open = [&] {
      const judge::Verdict verdict = fit().verdict;
      return verdict == judge::Verdict::undetermined || verdict == judge::Verdict::lower;
    };
    if (!is_open()) return;
    std::vector<double> solved;
    for (const Run& run : runs_)
      if (std::isfinite(run.point.error)) solved.push_back(run.row.setting);
    if (solved.empty()) return;
    run_between(tolerances_between(pair_, like, solved), false);
    if (at_floor_ == 0 && is_open())
      run_between(tolerances_beyond(pair_, like, solved.back()), true);
  }

  struct Run {
    ConvergenceRow row;
    std::vector<TimeRow> times = {};
    judge::ErrorPoint point = {};
  };

  std::vector<Run>::const_iterator run_of_least_error() const {
    return std::ranges::min_element(runs_, [](const Run& a, const Run& b) {
      return std::isfinite(a.point.error) && !(a.point.error >= b.point.error);
    });
  }

  bool order_is_open() const {
    const judge::OrderFit now = fit();
    if (now.verdict == judge::Verdict::undetermined) return true;
    if (now.verdict != judge::Verdict::lower && now.verdict != judge::Verdict::higher) return false;
    // Where runs are long, a low order that is clearly different needs no extra settings; high
    // orders converge late.
    const double claimed = claimed_order(pair_);
    return claimed > 6 || !(std::abs(now.order - claimed) > 0.75) || small_;
  }

  /// The step counts that were solved, down to the smallest error.
  std::vector<std::uint64_t> informative_step_counts() const {
    std::vector<std::uint64_t> informative;
    const std::uint64_t end = steps_of_least_error();
    for (const Run& run : runs_)
      if (std::isfinite(run.point.error) && run.row.steps <= end)
        informative.push_back(run.row.steps);
    return informative;
  }

  void run_between(const std::vector<Request>& requests, bool until_rounding) {
    double spent = 0;
    for (const Request& request : requests) {
      const double left = static_cast<double>(request.budget.evaluations) - spent;
      if (foreseen_.work(request) > left) break;
      std::erase_if(runs_, [&](const Run& run) {
        return pair_.mode == Mode::fixed
                   ? run.row.steps == request.steps
                   : std::abs(run.row.setting / request.tolerance.relative - 1) < 1e-6;
      });
      const Outcome outcome = pair_.entrant->solve(request);
      runs_.push_back(measure(request, outcome));
      if (small_ && until_rounding) spent += static_cast<double>(outcome.counters.work);
      if (pair_.mode == Mode::adaptive && outcome.status != Status::ok) break;
      if (!until_rounding || !near_rounding(runs_.back().point)) continue;
      at_floor_ = 1;
      break;
    }
    const auto finer = [&](const Run& a, const Run& b) {
      return pair_.mode == Mode::fixed ? a.row.steps > b.row.steps : a.row.setting < b.row.setting;
    };
    std::ranges::stable_sort(runs_, [&](const Run& a, const Run& b) { return finer(b, a); });
    // Where finer steps than those that the usual budget ended were paid for, it ended nothing.
    const Run least = *run_of_least_error();
    std::erase_if(runs_, [&](const Run& run) { return over_budget(run) && finer(least, run); });
  }

  static bool near_rounding(const judge::ErrorPoint& point) {
    return point.error <= 10 * (point.typical_rounding() + point.floor);
  }

  static bool over_budget(const Run& run) {
    return run.row.status == to_string(Status::over_budget);
  }

  Outcome run_unless_over_budget(const Request& request) {
    Outcome outcome;
    outcome.status = Status::over_budget;
    if (!runs_.empty() && over_budget(runs_.back()))
      outcome.detail = fmt::format(
          "not run: a coarser setting was over the budget of {} evaluations and products",
          request.budget.evaluations);
    else if (outcome.detail = foreseen_.excess(request); outcome.detail.empty())
      outcome = pair_.entrant->solve(request);
    if (outcome.status == Status::ok) foreseen_.add(request, outcome.counters.work);
    return outcome;
  }

  Run measure(const Request& request, const Outcome& outcome) const {
    Run run{.row = make_row(pair_, request, outcome)};
    ConvergenceRow& row = run.row;
    run.point = {.step = row.step, .error = nan};
    row.judged.answer = judge::Answer::none;
    if (!row.ok()) return run;
    const std::vector<judge::StopError> errors = judge_.errors(outcome);
    row.take_errors(errors);
    row.judged = measure::answer_of(request, outcome, errors, amplification_, pair_.c->truth.floor,
                                    judge_.scale());
    for (const judge::StopError& e : errors) run.times.push_back(time_row(row, e));
    run.point.error = row.error_rms;
    run.point.rounding_unit = rounding_unit_;
    run.point.scale = judge_.scale();
    run.point.components = static_cast<double>(judge_.components());
    run.point.floor = pair_.c->truth.floor;
    run.point.steps = static_cast<double>(row.steps);
    run.point.rejected = static_cast<double>(row.counters.rejected_steps);
    return run;
  }

  const Pair& pair_;
  const judge::Amplification& amplification_;
  judge::Judge judge_;
  double rounding_unit_;
  bool small_ = pair_.c->y0.size() <= dense_dimension_limit;
  std::vector<Run> runs_;
  int at_floor_ = 0;  ///< number of finest runs whose errors no longer fell, near rounding
  Foreseen foreseen_;
};

}  // namespace

const std::string& reason_against(const Pair& pair) {
  if (!pair.entrant->unfit.empty()) return pair.entrant->unfit;
  if (!pair.c->settings.no_convergence.empty()) return pair.c->settings.no_convergence;
  static const std::string none;
  return pair.mode == Mode::fixed ? pair.c->settings.no_fixed_steps : none;
}

ConvergenceResult not_measured(const Pair& pair, const std::string& reason) {
  const ConvergenceRow row = not_applicable(blank_row<ConvergenceRow>(pair), reason);
  judge::OrderFit fit;
  fit.verdict = judge::Verdict::not_applicable;
  fit.reason = reason;
  return {.rows = {row}, .orders = {make_order(pair, fit)}};
}

ConvergenceResult converge_pair(const Pair& pair, const CaseMeasures& measures, bool quick) {
  PairRuns runs(pair, measures);
  const std::vector<Request> requests = convergence_settings(pair, quick);
  runs.run_until_rounding(requests);
  if (quick) return std::move(runs).result();
  runs.run_extra_settings(requests.front());
  if (pair.mode == Mode::adaptive) return std::move(runs).result();
  const std::uint64_t end = runs.steps_of_least_error();
  ConvergenceResult result = std::move(runs).result();
  refit_in_extended_precision(pair, end, result.orders.front().fit);
  return result;
}

}  // namespace odeum::study
