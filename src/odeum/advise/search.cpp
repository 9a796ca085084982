// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace odeum::advise {
namespace {

// A short run that is timed once may take three times its least time, and 30 us more.
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

}  // namespace

double Candidate::slope() const { return mode == Mode::adaptive ? 1 : order(); }

double Candidate::order() const {
  if (std::isnan(entrant->info.order)) return mode == Mode::adaptive ? 4 : 2;
  return std::max(1.0, entrant->info.order);
}

double Search::in_range(const Candidate& candidate, double fineness) const {
  if (candidate.mode == Mode::adaptive)
    return std::clamp(fineness, 1 / loosest_tolerance, 1 / finest_tolerance);
  const auto multiple = static_cast<double>(multiple_);
  return multiple * std::ceil(std::clamp(fineness, 1.0, most_steps) / multiple * (1 - 1e-12));
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
  if (bracket_of(candidate, wishes_.error).reaches || !std::isfinite(best_ns_)) return;
  if (trial.status == Status::ok && trial.ns > slow_factor * best_ns_ + slow_ns)
    candidate.dropped = {
        fmt::format("it took {:.2g} times the time of the best run so far to an error of {:.2g}",
                    trial.ns / best_ns_, trial.error),
        "too slow before they had the error"};
}

/// A finer setting than that of a trial which misses the error: `expected` times as fine, or
/// between it and a run that was stopped.
double Search::finer_than(const Trial& misses, const Candidate& candidate, double expected) const {
  // An error as large as the solution tells nothing but that the run is unstable.
  const bool tells = misses.status == Status::ok && misses.error <= stages_.front().all.scale();
  const double factor = tells                              ? std::clamp(expected, 1.3, 1e3)
                        : candidate.mode == Mode::adaptive ? 4
                                                           : 2;
  double finer = factor * misses.fineness;
  for (const Trial& trial : candidate.trials)
    if (trial.status == Status::over_budget && trial.fineness > misses.fineness)
      finer = std::min(finer, std::sqrt(misses.fineness * trial.fineness));
  return finer;
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
  else if (misses)
    fineness = in_range(candidate, finer_than(*misses, candidate, 1.2 * by_error(*misses)));
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
    const Trial *coarse = bracket_of(candidate, wishes_.error).misses,
                &last = candidate.trials.back();
    // Nothing lies between a run that misses the error and one that takes too long.
    if (last.status == Status::over_budget && k > 0 && coarse &&
        last.fineness < 1.3 * coarse->fineness)
      break;
  }
  settle(candidate);
}

void Search::settle(Candidate& candidate) const {
  candidate.found.reset();
  if (const Trial* coarsest = bracket_of(candidate, wishes_.error).reaches)
    candidate.found = *coarsest;
}

void Search::refine(Candidate& candidate) {
  constexpr double eighth = 0.125;
  constexpr int most_moves = 4;
  search(candidate, 6, eighth);
  // A tenth of a step keeps from the edge of stability, too.
  const double wide = std::pow(10, 2 * eighth / candidate.slope()),
               step = candidate.mode == Mode::fixed ? std::min(wide, 1.1) : wide;
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
