// SPDX-License-Identifier: BSD-3-Clause
// The vectorised raster gives the same numbers as one solve at a time.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "odeum/cases/catalogue.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/studies/stability/raster_lanes.hpp"

namespace odeum::study::lanes_test {
namespace {

Probe lambda_probe() {
  for (const Case& c : all_cases())
    if (c.plane == "lambda") return c.probe();
  throw std::logic_error("no case has the lambda plane");
}

TEST(Lanes, ServeEveryExplicitTableauAndNothingElse) {
  EXPECT_NE(find_lane_runner("rk4"), nullptr);
  EXPECT_NE(find_lane_runner("cash_karp54"), nullptr);
  EXPECT_EQ(find_lane_runner("implicit_euler"), nullptr);
  EXPECT_EQ(find_lane_runner("leapfrog"), nullptr);
  EXPECT_EQ(find_lane_runner("no_such_method"), nullptr);
}

TEST(Lanes, EqualOneSolveAtATime) {
  // More values than lanes and no multiple of them: the last block is part full.
  std::vector<double> re, im;
  for (std::size_t i = 0; i < 2 * lanes + 5; ++i) {
    re.push_back(-3 + 0.03 * static_cast<double>(i));
    im.push_back(4 * std::sin(static_cast<double>(i)));
  }
  constexpr unsigned steps = 10;
  const Probe probe = lambda_probe();
  std::size_t methods = 0;
  for (const Entrant& entrant : probe.entrants) {
    const LaneRunner runner =
        entrant.info.library == "odeum" ? find_lane_runner(entrant.info.method) : nullptr;
    if (!runner) continue;
    ++methods;
    std::vector<double> squared(re.size());
    runner(re.data(), im.data(), re.size(), steps, squared.data());
    Request request;
    request.steps = steps;
    request.stops = {steps};
    for (std::size_t i = 0; i < re.size(); ++i) {
      probe.place(re[i], im[i]);
      const Outcome outcome = entrant.solve(request);
      ASSERT_EQ(outcome.status, Status::ok);
      const double expected =
          outcome.states[0] * outcome.states[0] + outcome.states[1] * outcome.states[1];
      // The compiler may contract a multiply and an add in one and not in the other: rounding of
      // some ten operations in each of ten steps, larger where stages cancel (|y| below 1).
      EXPECT_NEAR(squared[i], expected, 1e-12 * std::max(1.0, expected))
          << entrant.info.method << " z = " << re[i] << " + " << im[i] << "i";
    }
  }
  EXPECT_GE(methods, 4U);  // rk4, heun, midpoint and explicit_euler at the least
}

}  // namespace
}  // namespace odeum::study::lanes_test
