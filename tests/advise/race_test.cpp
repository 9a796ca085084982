// SPDX-License-Identifier: BSD-3-Clause
// The race for advice over solvers whose runs take known times.
#include "odeum/advise/race.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace odeum::advise::race_test
