// SPDX-License-Identifier: BSD-3-Clause
// The race for advice over solvers whose runs take known times.
#include "odeum/advise/race.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "odeum/advise/winner.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::advise::race_test {
namespace {

/// A solver whose run to the first stop has hardly an error. That of a whole run falls by a tenth
/// where the steps are halved.
Entrant entrant(const std::string& method, double order, double first_seconds, double seconds,
                double error) {
  Entrant made;
  made.info.library = "made";
  made.info.method = method;
  made.info.order = order;
  made.solve = [=](const Request& request) {
    const bool whole = request.stops.back() > 1;
    const double takes = whole ? seconds : first_seconds;
    const double limit = request.budget.seconds;
    const double until = study::thread_seconds() + std::min(takes, limit);
    while (study::thread_seconds() < until) continue;
    Outcome outcome;
    if (takes > limit) outcome.status = Status::over_budget;
    for (const double stop : request.stops) {
      const double y = 1 + (stop > 1 ? error * std::pow(request.steps, -0.15) : 1e-9 * error);
      outcome.record(stop, &y, 1);
    }
    return outcome;
  };
  return made;
}

// A rope hangs still up to its first stop. There one method seems the cheapest, and its
// runs to the end, which have too large an error at each step, took all the seconds.
TEST(Race, OneWithoutAnAnswerLeavesTimeForTheNext) {
  Case c;
  c.id = "still_at_first";
  c.y0 = {1};
  c.stops = {1, 10};
  c.truth.at = [](double, double* y) {
    y[0] = 1;
    return true;
  };
  c.entrants.add(entrant("seems_cheap", 4, 4e-4, 0.35, 0.5));
  c.entrants.add(entrant("answers", 8, 6e-4, 6e-3, 1e-4));
  Wishes wishes;
  wishes.error = 1e-3;
  wishes.seconds = 4;
  const Advice advice = advise({&c}, wishes);
  ASSERT_EQ(advice.failure, "");
  EXPECT_EQ(advice.candidates[advice.winner].entrant->info.method, "answers");
}

/// A run of that error and work.
Trial trial(double error, std::uint64_t work) {
  Trial made;
  made.parts.resize(1);
  made.error = error;
  made.counters.work = work;
  return made;
}

/// Of candidates timed in their order with an error of 1e-4 at a hundred evaluations, the winner,
/// and the reasons of those before it.
std::pair<std::size_t, std::vector<std::string>> winner_of(const std::vector<Trial>& repeated) {
  Advice advice;
  advice.wishes.error = 1e-4;
  for (std::size_t k = 0; k < repeated.size(); ++k) {
    advice.candidates.push_back({.entrant = nullptr, .mode = Mode::adaptive});
    advice.candidates.back().found = trial(1e-4, 100);
    advice.timed.push_back(k);
  }
  const std::vector<std::size_t> order = advice.timed;
  choose_winner(advice, order, [&](std::size_t k) { return repeated[k]; });
  EXPECT_EQ(advice.repeated.error, repeated[advice.winner].error);
  EXPECT_EQ(advice.timed.front(), advice.winner);
  std::vector<std::string> reasons;
  for (std::size_t k = 0; k < advice.winner; ++k) reasons.push_back(advice.candidates[k].dropped);
  return {advice.winner, reasons};
}

// Stops can help a run past a place by chance: alone it ends elsewhere, or takes a thousand times
// the steps.
TEST(Winner, IsTheFirstWhoseCommandMakesTheRunThatWasTimed) {
  const std::string off = "its run with no stop but the end fails or has over twice the error",
                    dear = "its run with no stop but the end takes over ten times the evaluations";
  using Reasons = std::vector<std::string>;
  EXPECT_EQ(winner_of({trial(1.9e-4, 900), trial(1e-4, 100)}),
            (std::pair{std::size_t{0}, Reasons{}}));
  EXPECT_EQ(winner_of({trial(1, 50), trial(1e-5, 5000), trial(1e-4, 120)}),
            (std::pair{std::size_t{2}, Reasons{off, dear}}));
  // Where none is as good, one that has the error; else the one that was the fastest.
  EXPECT_EQ(winner_of({trial(1, 50), trial(1e-5, 5000)}),
            (std::pair{std::size_t{1}, Reasons{off}}));
  EXPECT_EQ(winner_of({trial(1, 50), trial(1, 60)}), (std::pair{std::size_t{0}, Reasons{}}));
}

}  // namespace
}  // namespace odeum::advise::race_test
