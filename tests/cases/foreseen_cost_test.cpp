// SPDX-License-Identifier: BSD-3-Clause
// How long a truth that was cut short would take.
#include "odeum/cases/foreseen_cost.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <string>

#include "support/catalogue.hpp"

namespace odeum::foreseen_cost_test {
namespace {

truth::Reference spent_at(double t) {
  truth::Reference reference;
  reference.end = "the work is spent";
  reference.spent_at = t;
  reference.seconds = 30;
  return reference;
}

TEST(ForeseenCost, IsThatOfTheStepsThatAreLeft) {
  truth::Reference reference = spent_at(10);
  cases::foresee_cost(tests::find_case("robertson"), reference);
  std::smatch found;
  const std::regex sentence(
      "the work is spent; to the end it would take about ([0-9.e+]+) minutes, since bdf_variable "
      "takes ([0-9]+) of ([0-9]+) steps up to t = 10, as far as 30 s went");
  ASSERT_TRUE(std::regex_match(reference.end, found, sentence)) << reference.end;
  const double before = std::stod(found[2]), all = std::stod(found[3]);
  // Most of the steps lie before, and most of the time behind it.
  EXPECT_GT(all, before);
  EXPECT_LT(all, 10 * before);
  EXPECT_NEAR(std::stod(found[1]), 0.5 * all / before, 0.05 * all / before);  // two digits
}

// An explicit method whose steps are bound by stability goes on as it went.
TEST(ForeseenCost, OfExplicitMethodsIsThatOfTheTimeThatIsLeft) {
  truth::Reference reference = spent_at(4e8);
  reference.is_explicit = true;
  cases::foresee_cost(tests::find_case("robertson"), reference);
  EXPECT_EQ(reference.end,
            "the work is spent; to the end it would take about 8.3 hours, since 0.001 of the time "
            "4e+11 lies up to t = 4e+08, as far as 30 s went");
}

TEST(ForeseenCost, IsNotSaidWhereNothingWasSpentOrNoRunComesToTheEnd) {
  truth::Reference whole = spent_at(std::numeric_limits<double>::infinity());
  cases::foresee_cost(tests::find_case("robertson"), whole);
  EXPECT_EQ(whole.end, "the work is spent");
  truth::Reference none = spent_at(0);  // of which no step is known
  cases::foresee_cost(tests::find_case("robertson"), none);
  EXPECT_EQ(none.end, "the work is spent");
}

}  // namespace
}  // namespace odeum::foreseen_cost_test
