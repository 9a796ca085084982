// SPDX-License-Identifier: BSD-3-Clause
// The least error within a time: of each candidate the setting that takes the time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/advise/search.hpp"
#include "odeum/core/progress.hpp"

namespace odeum::advise {
namespace {

/// Shares of the time allowed: a search ends with a run above the first, an adjustment with one
/// above the third; the next run aims at the second.
constexpr double near_enough = 0.75, aimed_at = 0.97, near_the_end = 0.94;
/// A candidate is left where its error at the time is foreseen to be this far from the best.
constexpr double hopeless = 3000;

bool good(const Trial& trial, double ns) {
  return trial.status == Status::ok && trial.ns <= ns && std::isfinite(trial.error);
}

/// Time goes as the number of fixed steps, and as tol^(-1/p) for a method of order p.
double time_power(const Candidate& candidate) {
  return candidate.mode == Mode::fixed ? 1 : candidate.order();
}

/// The trial of least error that keeps to the time.
const Trial* best_of(const Candidate& candidate, double ns) {
  const Trial* best = nullptr;
  for (const Trial& trial : candidate.trials)
    if (good(trial, ns) && (!best || trial.error < best->error)) best = &trial;
  return best;
}

}  // namespace

void Search::take_within(Candidate& candidate, double fineness) {
  Trial trial = run(candidate, fineness);
  // A run under the guard, once and cold, may seem to take three times as long.
  constexpr double short_ns = 2e7;
  if (trial.status == Status::ok && trial.ns < short_ns) {
    for (int k = 0; k < 3; ++k) trial.ns = std::min(trial.ns, bare_ns(candidate, trial));
  }
  if (good(trial, wishes_.time_ns) && !candidate.closed_form())
    least_error_ = std::min(least_error_, trial.error);
  candidate.trials.push_back(std::move(trial));
}

double Search::foreseen_error(const Candidate& candidate) const {
  const Trial& trial = candidate.trials.back();
  if (!good(trial, wishes_.time_ns)) return nan;
  return trial.error * std::pow(wishes_.time_ns / trial.ns, -candidate.order());
}

void Search::search_within(Candidate& candidate) {
  constexpr std::size_t most_solves = 5;
  for (std::size_t k = 0; k < most_solves && candidate.dropped.empty() && !late(0.7); ++k) {
    // Nothing is to be had below the truth's own error.
    const Trial& last = candidate.trials.back();
    if (good(last, wishes_.time_ns) &&
        (last.ns > near_enough * wishes_.time_ns || last.error <= 2 * c_.truth.floor))
      break;
    // A third of the time tells whether the whole is worth it.
    const double fineness = settings_of(candidate).next_within(
        wishes_.time_ns, k == 0 && !dear_ ? 0.3 : 0.95, time_power(candidate));
    if (fineness == 0) break;
    take_within(candidate, fineness);
    if (const double foreseen = foreseen_error(candidate); foreseen > hopeless * least_error_)
      candidate.dropped = {fmt::format("its error would be {:.2g} within the time", foreseen),
                           "far behind within the time"};
  }
}

void Search::all_within(std::vector<Candidate>& candidates) {
  order_by_rank(candidates);
  if (heats(candidates)) {
    cap_seconds_ =
        std::max(2e-3, std::min(clock_.crowding() * 2e-9 * wishes_.time_ns, seconds_ / 4));
    each_worth(candidates, [&](Candidate& candidate) {
      take_within(candidate, first(candidate));
      search_within(candidate);
      settle_within(candidate);
    });
    return;
  }
  // First each at a coarse setting, in a quarter of the seconds.
  cap_seconds_ = std::max(2e-3, std::min(1e-8 * wishes_.time_ns,
                                         seconds_ / 4 / static_cast<double>(candidates.size())));
  Progress progress("advise", 2 * static_cast<double>(candidates.size()));
  std::vector<std::pair<double, std::size_t>> known, failed;
  for (std::size_t k = 0; k < candidates.size() && !late(0.3); ++k, progress.advance()) {
    take_within(candidates[k], first(candidates[k]));
    const double error = foreseen_error(candidates[k]);
    if (std::isnan(error))
      failed.emplace_back(candidates[k].trials.back().ns, k);
    else
      known.emplace_back(error, k);
  }
  // Then those of the least error that is foreseen, and in turn with them the cheapest of those
  // that failed there, which may be good at a finer one.
  std::ranges::sort(known);
  std::ranges::sort(failed);
  cap_seconds_ = std::max(2e-3, std::min(clock_.crowding() * 2e-9 * wishes_.time_ns, seconds_ / 4));
  for (std::size_t k = 0; k < std::max(known.size(), failed.size()) && !late(0.7); ++k) {
    for (const auto* list : {&known, &failed})
      if (k < list->size()) search_within(candidates[(*list)[k].second]);
    progress.advance();
  }
  for (Candidate& candidate : candidates) settle_within(candidate);
}

void Search::settle_within(Candidate& candidate) const {
  if (const Trial* best = best_of(candidate, wishes_.time_ns)) candidate.found = *best;
}

bool Search::adjust_within(Candidate& candidate, double ns) {
  const Trial was = *candidate.found;
  const bool slow = ns > wishes_.time_ns;
  if (!slow && (ns > near_the_end * wishes_.time_ns || was.error <= 2 * c_.truth.floor))
    return false;
  double fineness = in_range(
      candidate, was.fineness * std::pow(aimed_at * wishes_.time_ns / ns, time_power(candidate)));
  // Steps are whole multiples.
  if (slow && fineness >= was.fineness && candidate.mode == Mode::fixed)
    fineness = was.fineness - static_cast<double>(multiple_);
  if (!(fineness > 0) || fineness == was.fineness || (slow && fineness > was.fineness))
    return false;
  take_within(candidate, fineness);
  const Trial& trial = candidate.trials.back();
  if (trial.status != Status::ok || (!slow && !(trial.error < was.error))) return false;
  candidate.found = trial;
  return true;
}

}  // namespace odeum::advise
