// SPDX-License-Identifier: BSD-3-Clause
// Zeros of events that rounding and the errors of runs blur.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "odeum/cases/text_truth.hpp"
#include "support/hybrid_text.hpp"

namespace odeum::tests::event_zeros_test {
namespace {

// A belt and a mass that begins to slip tangentially: v - belt is then of rounding alone. The right
// end is that of SciPy, see tests/outside/hybrid.
TEST(EventZeros, WhatLeavesAThresholdTangentiallyIsNoEvent) {
  const HybridText text(R"text(
parameters: {belt: 0.2, grip: 1, delta: 3}
states: {x: 0, v: 0.2, slip: 0}
equations:
  x: "if(slip > 0.5, v, belt)"
  v: "if(slip > 0.5, -x + grip/(1 + delta*(belt - v)), 0)"
  slip: 0
time: {end: 25}
events:
  - {when: x - grip, rising: true, set: {slip: 1}}
  - {when: v - belt, rising: true, set: {slip: 0, v: belt}}
)text");
  for (const char* id : {"odeum/dormand_prince54", "odeum/rodas4", "odeum/radau_iia5"}) {
    const Outcome outcome = text.run(id, 1e-8);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_EQ(outcome.events.size(), 4U) << id;
    EXPECT_NEAR(outcome.states.end()[-3], 0.199587481, 1e-6) << id;  // 100 tolerances
  }
}

// Two or three roots within one step: by every own solver that runs to a tolerance, from any start.
TEST(EventZeros, AllRootsOfACubicByEveryOwnSolver) {
  int runs = 0;
  for (const double start : {-20.0, -5.9}) {
    const HybridText text(fmt::format(
        R"text(
states: {{y: {}, n: 0, sum: 0}}
equations: {{y: 3*t^2 + 12*t - 4, n: 0, sum: 0}}
time: {{start: {}, end: 50}}
events:
  - {{when: y, set: {{n: n + 1, sum: sum + t}}}}
)text",
        (start + 6) * (start + 2) * (start - 2), start));
    const double n = start < -6   ? 3
                     : start < -2 ? 2
                                  : 1,
                 sum = start < -6   ? -6
                       : start < -2 ? 0
                                    : 2;
    for (const Entrant& entrant : cases::enroll(text.contest)) {
      const SolverInfo& info = entrant.info;
      if (info.library != "odeum" || !entrant.unfit.empty() || !info.adaptive || info.order < 2)
        continue;
      const Outcome outcome = text.run(info.id(), 1e-6);
      ASSERT_EQ(outcome.status, Status::ok) << info.id() << ' ' << outcome.detail;
      ++runs;
      EXPECT_NEAR(outcome.states.end()[-2], n, 1e-9) << info.id() << " from " << start;
      EXPECT_NEAR(outcome.states.end()[-1], sum, 0.1) << info.id() << " from " << start;
    }
  }
  EXPECT_GE(runs, 2 * 40);
}

// Rounding decides whether x = (t - c)^2 comes to zero, and whether once or twice: nothing is
// claimed of what follows. Where it misses zero, or passes, all is known.
TEST(EventZeros, ATruthDoesNotClaimWhatRoundingDecides) {
  const auto events_of = [](const char* x0, const char* c) {
    const HybridText text(fmt::format(
        R"text(
states: {{x: {}, n: 0}}
equations: {{x: 2*(t - {}), n: 0}}
time: {{end: 3, stops: [3]}}
events:
  - {{when: x, set: {{n: n + 1}}}}
)text",
        x0, c));
    std::vector<long double> y(2, -1);
    cases::truth_of(text.ode).extended(3, y.data());
    return static_cast<double>(y[1]);
  };
  EXPECT_EQ(events_of("0.917764", "0.958"), -1);
  EXPECT_EQ(events_of("1.69", "1.3"), -1);
  EXPECT_EQ(events_of("0.36", "0.6"), -1);
  EXPECT_EQ(events_of("0.917765", "0.958"), 0);
  EXPECT_EQ(events_of("0.917763", "0.958"), 2);
  EXPECT_EQ(events_of("1.70", "1.3"), 0);
  EXPECT_EQ(events_of("1.68", "1.3"), 2);
}

// An event by the clock on a stop stays on it, however constants are rounded.
TEST(EventZeros, AnEventOnTheLastStopIsKnown) {
  const HybridText text(R"text(
states: {x: 1, since: 0}
equations: {x: -x, since: 0}
time: {end: 0.006, stops: [0.006]}
events:
  - {at: 4e-4, every: 4e-4, set: {since: t}}
)text");
  std::vector<long double> y(2, -1);
  EXPECT_TRUE(cases::truth_of(text.ode).extended(0.006, y.data()));
  EXPECT_NEAR(static_cast<double>(y[1]), 0.006, 1e-17);
}

// A run to an event is another one than that in which it was found, and may end on its other side.
TEST(EventZeros, AnEventIsOneHoweverItsRunEnds) {
  const HybridText text(R"text(
states: {y: 0, v: 1, count: 0}
equations: {y: v, v: -y, count: 0}
time: {end: 50}
events:
  - {when: y, set: {count: count + 1}}
)text");
  for (const char* id :
       {"odeum/dormand_prince54", "odeum/rodas4", "cvode/bdf", "cvode/adams", "gsl/msbdf"}) {
    const Entrants entrants = cases::enroll(text.contest);
    if (!entrants.find(id)) continue;
    const Outcome outcome = text.run(id, 1e-6);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_EQ(outcome.events.size(), 15U) << id;  // 50 / pi, rounded down
  }
}

}  // namespace
}  // namespace odeum::tests::event_zeros_test
