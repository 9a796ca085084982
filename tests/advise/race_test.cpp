// SPDX-License-Identifier: BSD-3-Clause
// The race for advice over solvers whose runs take known times.
#include "odeum/advise/race.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "odeum/advise/winner.hpp"

namespace odeum::advise::race_test {
namespace {

double now = 0;  ///< seconds, which the solvers move on

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
    const double limit = request.budget.watched ? request.budget.seconds : infinity;
    now += std::min(takes, limit);
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
  wishes.clock = [] { return now; };
  const Advice advice = advise({&c}, wishes);
  ASSERT_EQ(advice.failure, "");
  EXPECT_EQ(advice.candidates[advice.winner].entrant->info.method, "answers");
}

/// A run of that error and work.
Trial trial(double error, std::uint64_t work) {
  Trial made;
  made.parts.resize(1);
  made.error = error;
  made.parts.front().counters.work = work;
  return made;
}

/// An advice on candidates that were timed in their order, each a tenth slower than the one before,
/// with an error of 1e-4 at a hundred evaluations; `made` are the runs of their commands.
Advice chosen_of(const std::vector<Trial>& made, bool may_stop) {
  static const Entrant any = entrant("any", 4, 0, 0, 0);
  Advice advice;
  advice.wishes.error = 1e-4;
  advice.wishes.may_stop = may_stop;
  for (std::size_t k = 0; k < made.size(); ++k) {
    advice.candidates.push_back({.entrant = &any, .mode = Mode::adaptive});
    advice.candidates.back().found = trial(1e-4, 100);
    advice.candidates.back().times.ns = {100 + 10.0 * static_cast<double>(k)};
    advice.timed.push_back(k);
  }
  const std::vector<std::size_t> order = advice.timed;
  choose_winner(advice, order, [&](std::size_t k) { return made[k]; });
  return advice;
}

// Stops can help a run past a place by chance: alone it ends elsewhere, or takes a thousand times
// the steps. A command whose run had up to twice the error asked for was an answer.
TEST(Winner, IsTheFirstWhoseCommandKeepsTheError) {
  const Advice advice =
      chosen_of({trial(1.9e-4, 90), trial(1e-5, 5000), trial(0.9e-4, 120)}, false);
  ASSERT_EQ(advice.failure, "");
  EXPECT_EQ(advice.winner, 2U);
  EXPECT_FALSE(advice.on_stops);
  EXPECT_EQ(advice.timed, (std::vector<std::size_t>{2}));
  EXPECT_EQ(advice.candidates[2].found->error, 0.9e-4);  // the command's own run
  EXPECT_EQ(advice.candidates[0].dropped.why, "its run with no stop but the end misses the error");
  EXPECT_EQ(advice.candidates[1].dropped.why,
            "its run with no stop but the end takes over ten times the evaluations");
}

TEST(Winner, EndsItsStepsOnTheStopsWhereThatIsMuchFaster) {
  // The third takes 20 % longer, the fourth 30 %.
  const Trial misses = trial(1, 50), keeps = trial(1e-4, 100);
  Advice advice = chosen_of({misses, misses, keeps, keeps}, true);
  EXPECT_EQ(advice.winner, 2U);
  EXPECT_FALSE(advice.on_stops);
  advice = chosen_of({misses, misses, misses, keeps}, true);
  EXPECT_EQ(advice.winner, 0U);
  EXPECT_TRUE(advice.on_stops);
  EXPECT_EQ(advice.candidates[0].found->error, 1e-4);  // the run that was timed
  EXPECT_TRUE(advice.candidates[0].dropped.empty());
}

TEST(Winner, IsNobodyWhoseCommandMissesTheError) {
  const Advice advice = chosen_of({trial(1, 50), trial(1, 60)}, false);
  EXPECT_EQ(advice.failure,
            "nobody here keeps that in a run with no stop but the end: made/any has an error of "
            "0.0001 in one whose steps end on the stops");
}

}  // namespace
}  // namespace odeum::advise::race_test
