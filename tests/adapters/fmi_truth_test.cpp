// SPDX-License-Identifier: BSD-3-Clause
// What is known of FMUs with events: two methods in extended precision that agree, held against
// closed forms; or nothing, which is said.
#include <cmath>

#include "fmi_hybrid_stage.hpp"

namespace odeum::fmi_tests::fmi_truth_test {
namespace {

class Truths : public HybridFmus {
 protected:
  Case completed(const Model& model, const Values& values = {}, const std::string& inputs = {}) {
    Case c = hybrid(model, values, inputs);
    complete(c);
    return c;
  }
};

/// h and v of the ball between two bounces, of which there are `bounces` before t.
std::pair<long double, long double> flying(long double t, int bounces) {
  const long double g = 9.81L, fall = std::sqrt(2 / g), e = 0.7L;
  long double since = fall, speed = e * g * fall;
  for (int k = 1; k < bounces; ++k) since += 2 * speed / g, speed *= e;
  if (bounces == 0) since = 0, speed = 0;
  const long double s = t - since;
  return {(bounces == 0 ? 1 : 0) + speed * s - g / 2 * s * s, speed - g * s};
}

TEST_P(Truths, ABallIsKnownAcrossItsBounces) {
  const Case c = completed(ball());
  double y[2];
  // Bounces are at 0.4515, 1.0837, 1.5261, 1.8358, 2.0526, ..., and it rests from 2.5 on.
  ASSERT_TRUE(c.truth.at(0.75, y)) << c.truth.source;
  const auto [h, v] = flying(0.75L, 1);
  EXPECT_NEAR(y[0], static_cast<double>(h), c.floor_of(0));
  EXPECT_NEAR(y[1], static_cast<double>(v), c.floor_of(1));
  ASSERT_TRUE(c.truth.at(1.5, y)) << c.truth.source;
  const auto [h2, v2] = flying(1.5L, 2);
  EXPECT_NEAR(y[0], static_cast<double>(h2), c.floor_of(0));
  EXPECT_NEAR(y[1], static_cast<double>(v2), c.floor_of(1));
  ASSERT_TRUE(c.truth.at(3, y)) << c.truth.source;
  EXPECT_NEAR(y[0], 0, c.floor_of(0));
  EXPECT_EQ(y[1], 0);
  EXPECT_LT(c.truth.floor, 1e-10) << c.truth.source;
}

TEST_P(Truths, AThermostatIsKnownAcrossItsSwitches) {
  const Case c = completed(thermostat());
  double y[1];
  for (const double t : {1.0, 2.0, 3.0, 4.0}) {
    ASSERT_TRUE(c.truth.at(t, y)) << c.truth.source;
    const long double half = std::log(1.5L), since = static_cast<long double>(t) - std::log(1.25L);
    const auto swings = static_cast<int>(std::floor(since / half));
    const long double s = since - half * swings;
    // It begins by rising to 6, from where it falls.
    const long double exact = swings % 2 == 0 ? 6 * std::exp(-s) : 10 - 6 * std::exp(-s);
    EXPECT_NEAR(y[0], static_cast<double>(exact), c.floor_of(0)) << t;
  }
  EXPECT_LT(c.truth.floor, 1e-10) << c.truth.source;
}

TEST_P(Truths, InputsWithKinksAndJumpsAreKnown) {
  const Case c = completed(follow(), {}, csv("time,u\n0,0\n1,1\n1,3\n2.2,3\n"));
  double y[1];
  ASSERT_TRUE(c.truth.at(0.75, y)) << c.truth.source;
  EXPECT_NEAR(y[0], 0.75 - 1 + std::exp(-0.75), c.floor_of(0) + 1e-16);
  ASSERT_TRUE(c.truth.at(3, y)) << c.truth.source;
  EXPECT_NEAR(y[0], 3 + (std::exp(-1.0) - 3) * std::exp(-2.0), c.floor_of(0) + 1e-15);
  EXPECT_LT(c.truth.floor, 1e-10) << c.truth.source;
}

TEST_P(Truths, WhatIsNotKnownIsSaid) {
  double y[1];
  const Case counter = completed(stair());
  EXPECT_FALSE(counter.truth.at(5, y));
  EXPECT_NE(counter.truth.source.find("no continuous states"), std::string::npos)
      << counter.truth.source;
  if (!three()) return;
  const Case stepped = completed(steps("needsCompletedIntegratorStep=\"true\""));
  EXPECT_FALSE(stepped.truth.at(1, y));
  EXPECT_NE(stepped.truth.source.find("depends on the steps"), std::string::npos)
      << stepped.truth.source;
}

INSTANTIATE_TEST_SUITE_P(Versions, Truths, testing::Values(2, 3));

}  // namespace
}  // namespace odeum::fmi_tests::fmi_truth_test
