// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"

namespace odeum::advise {
namespace {

// A single short run may take three times its least time, and some of that whatever it does.
constexpr double slow_factor = 3, slow_ns = 3e4;
constexpr double finest_tolerance = 1e-14, loosest_tolerance = 1e-1, most_steps = 1e8;

/// The finest that missed the error and is coarser than all that reach it, and the coarsest that
/// reaches it.
struct Bracket {
  const Trial *misses = nullptr, *reaches = nullptr;
};

Bracket bracket_of(const Candidate& candidate, double error) {
  Bracket bracket;
  for (const Trial& trial : candidate.trials)
    if (trial.reaches(error) && (!bracket.reaches || trial.fineness < bracket.reaches->fineness))
      bracket.reaches = &trial;
  for (const Trial& trial : candidate.trials)
    if (!trial.reaches(error) && trial.status != Status::over_budget &&
        (!bracket.reaches || trial.fineness < bracket.reaches->fineness) &&
        (!bracket.misses || trial.fineness > bracket.misses->fineness))
      bracket.misses = &trial;
  return bracket;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

double Candidate::slope() const {
  if (mode == Mode::adaptive) return 1;
  return std::isnan(entrant->info.order) ? 2 : std::max(1.0, entrant->info.order);
}

bool Candidate::closed_form() const { return entrant->info.id() == "odeum/exponential_propagator"; }

Search::Search(const Case& c, const Wishes& wishes, std::uint64_t frames)
    : c_(c),
      wishes_(wishes),
      judge_(c, c.stops),
      end_judge_(c, {c.stops.back()}),
      multiple_(frames > 0 ? std::lcm(frames, c.settings.steps_multiple)
                           : c.settings.steps_multiple) {}

bool Search::late(double share) const { return seconds_since(start_) > share * wishes_.seconds; }

Trial Search::run(const Candidate& candidate, double fineness, bool only_end) const {
  if (interrupted) throw Interrupted();
  Trial trial;
  Request& request = trial.request;
  request.mode = candidate.mode;
  request.stops = only_end ? std::vector<double>{c_.stops.back()} : c_.stops;
  if (candidate.mode == Mode::adaptive)
    set_tolerance(request, c_, 1 / fineness);
  else
    request.steps = static_cast<std::uint64_t>(fineness);
  const double left = std::max(0.01, wishes_.seconds - seconds_since(start_));
  request.budget.seconds =
      std::min(left, std::isfinite(best_ns_) ? std::max(2e-3, 1e-8 * best_ns_) : cap_seconds_);
  trial.fineness = fineness;
  const double start = study::thread_seconds();
  const Outcome outcome = candidate.entrant->solve(request);
  trial.counters = outcome.counters;
  trial.ns = std::max(1.0, 1e9 * (study::thread_seconds() - start) -
                               4.0 * static_cast<double>(outcome.counters.rhs_evaluations));
  trial.status = outcome.status;
  if (outcome.status != Status::ok) return trial;
  trial.error = 0;
  for (const judge::StopError& at : (only_end ? end_judge_ : judge_).errors(outcome))
    if (!(at.error_max <= trial.error)) trial.error = at.error_max;
  return trial;
}

double Search::in_range(const Candidate& candidate, double fineness) const {
  if (candidate.mode == Mode::adaptive)
    return std::clamp(fineness, 1 / loosest_tolerance, 1 / finest_tolerance);
  const auto multiple = static_cast<double>(multiple_);
  return multiple * std::ceil(std::clamp(fineness, 1.0, most_steps) / multiple * (1 - 1e-12));
}

double Search::first(const Candidate& candidate) const {
  if (candidate.mode == Mode::adaptive)
    return in_range(candidate, wishes_.error > 0 ? 1 / wishes_.error : 1e3);
  return in_range(candidate, static_cast<double>(c_.settings.coarsest_steps));
}

void Search::take(Candidate& candidate, double fineness) {
  candidate.trials.push_back(run(candidate, fineness));
  const Trial& trial = candidate.trials.back();
  if (trial.reaches(wishes_.error) && !candidate.closed_form())
    best_ns_ = std::min(best_ns_, trial.ns);
  drop_if_slow(candidate);
}

void Search::drop_if_slow(Candidate& candidate) const {
  const Trial& trial = candidate.trials.back();
  const Bracket bracket = bracket_of(candidate, wishes_.error);
  if (bracket.reaches || !std::isfinite(best_ns_)) return;
  if (trial.status == Status::ok && trial.ns > slow_factor * best_ns_ + slow_ns)
    candidate.dropped =
        fmt::format("it took {:.2g} times the time of the best run so far to an error of {:.2g}",
                    trial.ns / best_ns_, trial.error);
}

/// The fineness of the next run; 0: the search has ended.
double Search::next(const Candidate& candidate, double decades) const {
  const auto [misses, reaches] = bracket_of(candidate, wishes_.error);
  const double slope = candidate.slope();
  const auto by_error = [&](const Trial& trial) {
    return std::pow(std::clamp(trial.error / wishes_.error, 1e-30, 1e30), 1 / slope);
  };
  double fineness = 0;
  if (misses && reaches) {
    const double ratio = reaches->fineness / misses->fineness;
    if (ratio <= std::pow(10, decades / slope)) return 0;
    double part = 0.5;  // of the way from the one that misses, in logarithms
    if (misses->status == Status::ok && std::isfinite(misses->error) && reaches->error > 0)
      part = std::clamp(
          std::log(misses->error / wishes_.error) / std::log(misses->error / reaches->error) * 1.05,
          0.15, 0.85);
    fineness = in_range(candidate, misses->fineness * std::pow(ratio, part));
    if (fineness <= misses->fineness || fineness >= reaches->fineness) {
      fineness = in_range(candidate, misses->fineness * std::sqrt(ratio));
      if (fineness <= misses->fineness || fineness >= reaches->fineness) return 0;
    }
    return fineness;
  }
  if (reaches)
    fineness =
        in_range(candidate, reaches->fineness * std::clamp(by_error(*reaches), 1e-3, 1 / 1.3));
  else if (misses && misses->status == Status::ok && std::isfinite(misses->error))
    fineness =
        in_range(candidate, misses->fineness * std::clamp(1.2 * by_error(*misses), 1.3, 1e3));
  else if (misses)
    fineness = in_range(candidate, 4 * misses->fineness);
  else  // over the budget at once: from a coarse setting on
    fineness = in_range(candidate, candidate.trials.back().fineness / 30);
  for (const Trial& trial : candidate.trials)
    if (trial.fineness == fineness) return 0;
  return fineness;
}

void Search::search(Candidate& candidate, std::size_t most, double decades) {
  for (std::size_t k = 0; k < most && candidate.dropped.empty(); ++k) {
    const double fineness = next(candidate, decades);
    if (fineness == 0) break;
    take(candidate, fineness);
    const Trial& trial = candidate.trials.back();
    if (trial.status == Status::over_budget && k > 0) break;
  }
  settle(candidate);
}

void Search::settle(Candidate& candidate) const {
  candidate.found.reset();
  if (const Trial* coarsest = bracket_of(candidate, wishes_.error).reaches)
    candidate.found = *coarsest;
}

void Search::order_by_rank(std::vector<Candidate>& candidates) {
  // Where each solve takes long, not all have their turn: first those of orders 4 to 8 with a
  // controller. That orders them, and drops none.
  const auto rank = [](const Candidate& candidate) {
    const double claimed = candidate.entrant->info.order;
    const double apart = std::isnan(claimed) ? 4 : std::max({0.0, 4 - claimed, claimed - 8});
    return apart + (candidate.mode == Mode::fixed ? 0.5 : 0);
  };
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Candidate& a, const Candidate& b) { return rank(a) < rank(b); });
}

void Search::all(std::vector<Candidate>& candidates) {
  order_by_rank(candidates);
  cap_seconds_ = wishes_.seconds / (4.0 * static_cast<double>(candidates.size()));
  Progress progress("advise", 2.0 * static_cast<double>(candidates.size()));
  std::vector<std::pair<double, std::size_t>> order;  // by the cost foreseen
  for (std::size_t k = 0; k < candidates.size(); ++k, progress.advance()) {
    if (late(0.5)) break;
    take(candidates[k], first(candidates[k]));
    const Trial& trial = candidates[k].trials.back();
    const double order_of_cost = std::isnan(candidates[k].entrant->info.order)
                                     ? 4
                                     : std::max(1.0, candidates[k].entrant->info.order);
    order.emplace_back(
        std::isnan(trial.error)
            ? infinity
            : trial.ns * std::pow(std::max(trial.error, 1e-17) / wishes_.error, 1 / order_of_cost),
        k);
  }
  std::stable_sort(order.begin(), order.end());
  constexpr std::size_t most_solves = 8;
  constexpr double half_a_decade = 0.5;
  for (const auto& [cost, k] : order) {
    // Nobody has ended a run: coarser ones are tried below, with more time.
    if (late(0.7) || (cost == infinity && !std::isfinite(best_ns_))) break;
    search(candidates[k], most_solves, half_a_decade);
    progress.advance();
  }
  // Where each solve takes long, the first runs had too little time.
  while (!std::isfinite(best_ns_) && !late(0.7) && cap_seconds_ < wishes_.seconds) {
    cap_seconds_ *= 8;
    bool any = false;
    for (Candidate& candidate : candidates) {
      if (late(0.7)) break;
      if (candidate.trials.empty() || candidate.trials.back().status != Status::over_budget)
        continue;
      any = true;
      const double again = candidate.trials.back().fineness;
      candidate.trials.pop_back();
      take(candidate, again);
      search(candidate, most_solves, half_a_decade);
    }
    if (!any) break;
  }
  for (Candidate& candidate : candidates) settle(candidate);
}

void Search::refine(Candidate& candidate) {
  constexpr double eighth = 0.125;
  constexpr int most_moves = 4;
  search(candidate, 6, eighth);
  const double step = std::pow(10, 2 * eighth / candidate.slope());
  for (int move = 0; candidate.found && move < most_moves && !late(0.9); ++move) {
    const double finer = in_range(candidate, candidate.found->fineness * step),
                 coarser = in_range(candidate, candidate.found->fineness / step);
    const Trial above = run(candidate, finer), below = run(candidate, coarser);
    const bool lucky = !below.reaches(2 * wishes_.error);
    if (above.reaches(2 * wishes_.error) && (!lucky || move + 1 == most_moves)) return;
    if (!above.reaches(wishes_.error)) return;
    candidate.trials.push_back(above);
    candidate.found = above;
  }
}

}  // namespace odeum::advise
