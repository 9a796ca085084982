// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "odeum/report/facts.hpp"
#include "support/catalogue.hpp"

namespace odeum::report::facts_test {
namespace {

// A text of mechanics was said to be in seconds, for its tag, whatever its equations are in.
TEST(Facts, TimeHasAUnitOnlyWhereTheProblemIsAScene) {
  Case text = tests::find_case("pendulum_small"), scene = tests::find_case("free_fall");
  text.entrants = {}, scene.entrants = {};
  for (const Case* each : {&text, &scene})
    ASSERT_NE(std::find(each->tags.begin(), each->tags.end(), "mechanical"), each->tags.end());
  const Facts facts = describe({&text, &scene}, {});
  EXPECT_EQ(facts.cases[0].unit, "");
  EXPECT_EQ(facts.cases[1].unit, "s");
}

}  // namespace
}  // namespace odeum::report::facts_test
