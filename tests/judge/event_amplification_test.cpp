// SPDX-License-Identifier: BSD-3-Clause
// How errors pass events: by the derivatives of their times and of what they reset.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/judge/amplification.hpp"
#include "odeum/solvers/event_run.hpp"
#include "support/hybrid_text.hpp"

namespace odeum::tests::event_amplification_test {
namespace {

// x grows from 0 to 1 and begins again: an error of x makes the event as much earlier or later,
// and stays what it is. Differences that begin or end at an event would be those of the reset.
TEST(Amplification, OfASawtoothIsThatOfItsSlope) {
  const HybridText text(R"text(
states: {x: 0, n: 0}
equations: {x: 1, n: 0}
time: {end: 40.6}
events:
  - {when: x - 1, rising: true, set: {x: 0, n: n + 1}}
)text");
  Case c;
  c.y0 = {0, 0};
  c.stops = {20.3, 40.6};
  c.problem = text.contest;
  c.truth.at = [](double t, double* y) {
    y[0] = t - std::floor(t), y[1] = std::floor(t);
    return true;
  };
  const judge::Amplification found = judge::measure_amplification(c, c.stops);
  ASSERT_EQ(found.unknown, "");
  for (const double at : found.at_stops) {
    // sqrt(2) (1 + |x|), which is 1 to 2 where it is largest; n has no error.
    EXPECT_GT(at, std::sqrt(2.0));
    EXPECT_LT(at, 2 * std::sqrt(2.0) + 1e-3);
  }
}

TEST(Amplification, IsMeasuredFromTimesBetweenEvents) {
  const std::vector<double> events{1, 2, 4};
  EXPECT_EQ(between_events(2, events, 0, 10), 3);
  EXPECT_EQ(between_events(3.9, events, 0, 10), 3);
  EXPECT_EQ(between_events(0.1, events, 0, 10), 0.1);
  EXPECT_EQ(between_events(0.9, events, 0, 10), 0.5);
  EXPECT_EQ(between_events(5, events, 0, 10), 7);
  EXPECT_EQ(between_events(9, events, 0, 10), 9);
  EXPECT_EQ(between_events(9, {}, 0, 10), 9);
}

}  // namespace
}  // namespace odeum::tests::event_amplification_test
