// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace odeum::advise {
namespace {

// A short run that is timed once may take three times its least time, and 30 us more.
constexpr double slow_factor = 3, slow_ns = 3e4;
}  // namespace

double Candidate::slope() const { return mode == Mode::adaptive ? 1 : order(); }

double Candidate::order() const {
  if (std::isnan(entrant->info.order)) return mode == Mode::adaptive ? 4 : 2;
  return std::max(1.0, entrant->info.order);
}

measure::SettingGrid Search::grid_of(const Candidate& candidate) const {
  return {.mode = candidate.mode, .multiple = multiple_};
}

measure::SettingSearch Search::settings_of(const Candidate& candidate, double decades) const {
  return {.grid = grid_of(candidate),
          .tried = {candidate.trials.begin(), candidate.trials.end()},
          .slope = candidate.slope(),
          .narrow = std::pow(10, decades / candidate.slope()),
          .size = stages_.front().all.scale()};
}

const Trial* Search::coarsest_of(const Candidate& candidate) const {
  const auto at = settings_of(candidate).bracket(wishes_.error).reaches;
  return at < 0 ? nullptr : &candidate.trials[static_cast<std::size_t>(at)];
}

double Search::in_range(const Candidate& candidate, double fineness) const {
  return grid_of(candidate).on_grid(fineness);
}

double Search::coarser_than(const Candidate& candidate, double fineness) const {
  return in_range(candidate, fineness / (candidate.mode == Mode::adaptive ? 10 : 2));
}

double Search::first(const Candidate& candidate) const {
  if (candidate.starts_at > 0) return candidate.starts_at;
  if (candidate.mode == Mode::adaptive)
    return in_range(candidate, wishes_.error > 0 ? 1 / wishes_.error : 1e3);
  return in_range(candidate, static_cast<double>(c_.settings.coarsest_steps));
}

void Search::take(Candidate& candidate, double fineness) {
  candidate.trials.push_back(run(candidate, fineness));
  const Trial& trial = candidate.trials.back();
  if (trial.reaches(wishes_.error) && !candidate.closed_form())
    best_ns_ = std::min(best_ns_, trial.ns);
  if (coarsest_of(candidate) || !std::isfinite(best_ns_)) return;
  if (trial.status == Status::ok && trial.ns > slow_factor * best_ns_ + slow_ns)
    candidate.dropped = {
        fmt::format("it took {:.2g} times the time of the best run so far to an error of {:.2g}",
                    trial.ns / best_ns_, trial.error),
        "too slow before they had the error"};
}

void Search::search(Candidate& candidate, std::size_t most, double decades) {
  for (std::size_t k = 0; k < most && candidate.dropped.empty(); ++k) {
    const double fineness = settings_of(candidate, decades).next(wishes_.error);
    if (fineness == 0) break;
    take(candidate, fineness);
    const Trial& last = candidate.trials.back();
    const auto coarse = settings_of(candidate).bracket(wishes_.error).misses;
    // Nothing lies between a run that misses the error and one that takes too long.
    if (last.status == Status::over_budget && k > 0 && coarse >= 0 &&
        last.fineness < 1.3 * candidate.trials[static_cast<std::size_t>(coarse)].fineness)
      break;
  }
  settle(candidate);
}

void Search::settle(Candidate& candidate) const {
  candidate.found.reset();
  if (const Trial* coarsest = coarsest_of(candidate)) candidate.found = *coarsest;
}

void Search::refine(Candidate& candidate) {
  constexpr double eighth = 0.125, quarter = 0.25;
  constexpr int most_moves = 4;
  search(candidate, 6, eighth);
  // A tenth of a step keeps from the edge of stability, too.
  const double wide = std::pow(10, 2 * eighth / candidate.slope()),
               step = candidate.mode == Mode::fixed ? std::min(wide, 1.1) : wide;
  for (int move = 0; candidate.found && move < most_moves && !late(0.9); ++move) {
    const Trial above = run(candidate, in_range(candidate, candidate.found->fineness * step)),
                below = run(candidate, in_range(candidate, candidate.found->fineness / step)),
                close = run(candidate, in_range(candidate, candidate.found->fineness /
                                                               std::pow(step, quarter)));
    const bool lucky = !below.reaches(2 * wishes_.error) || !close.reaches(2 * wishes_.error);
    if (above.reaches(2 * wishes_.error) && (!lucky || move + 1 == most_moves)) return;
    if (!above.reaches(wishes_.error)) return;
    candidate.trials.push_back(above);
    candidate.found = above;
  }
}

}  // namespace odeum::advise
