// SPDX-License-Identifier: BSD-3-Clause
// The search for a limit, on growth functions whose limit is known.
#include "odeum/judge/stability_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace odeum::judge::search_test {
namespace {

/// The last bisection interval has this relative width.
constexpr double width = search_width;
constexpr double infinity = std::numeric_limits<double>::infinity();

Growth exact(double log_per_step) { return {log_per_step, growth_rounding}; }

TEST(StabilitySearch, FindsWhereDecayTurnsIntoGrowth) {
  for (const double limit : {0.003, 0.1, 2.0, 2.785293563405282, 37.5, 5e3}) {
    const LimitFound found = find_limit([&](double x) { return exact(x - limit); });
    EXPECT_NEAR(found.limit, limit, width * std::max(1.0, limit));
    EXPECT_FALSE(found.fails);
  }
}

TEST(StabilitySearch, NeutralUpToAnAbruptOnset) {
  // As leapfrog on the oscillator: nothing at all up to 2, then a square root.
  const LimitFound found =
      find_limit([](double x) { return exact(x <= 2 ? 0 : 2 * std::sqrt(x - 2)); });
  EXPECT_NEAR(found.limit, 2, 2 * width);
}

TEST(StabilitySearch, NeutralUpToAnOnsetThatRisesLinearly) {
  const LimitFound found = find_limit([](double x) { return exact(std::max(0.0, x - 1.5)); });
  EXPECT_NEAR(found.limit, 1.5, 1.5 * width);
}

TEST(StabilitySearch, PowerLawsBelowRoundingMeanThatThereIsNoLimit) {
  // log |R(iy)| ~ C y^q of Runge-Kutta methods of order 1 to 11; the cosine bends the law as terms
  // of higher order do, the last digits are rounding.
  for (const int q : {2, 4, 6, 8, 10, 12})
    for (const double c : {0.5, 1e-2, 1e-5}) {
      const LimitFound found = find_limit([&](double y) {
        const double rounding = 1e-15 * std::sin(1e6 * y);
        return exact(c * std::pow(y, q) * (1 + 0.3 * (1 - std::cos(y))) + rounding);
      });
      EXPECT_EQ(found.limit, 0) << "power " << q << " factor " << c;
    }
}

TEST(StabilitySearch, ATinyDecayBelowTheOnsetIsAStableInterval) {
  // As RK4 on the imaginary axis: -y^6/144 + y^8/1152 is below rounding at first, too.
  const LimitFound found =
      find_limit([](double y) { return exact(-std::pow(y, 6) / 144 + std::pow(y, 8) / 1152); });
  EXPECT_NEAR(found.limit, std::sqrt(8.0), 3 * width);
}

TEST(StabilitySearch, NoLimit) {
  EXPECT_EQ(find_limit([](double) { return exact(0); }).limit, infinity);
  EXPECT_EQ(find_limit([](double x) { return exact(-std::log1p(x)); }).limit, infinity);
}

TEST(StabilitySearch, ReturnsTheFirstOfSeveralCrossings) {
  // Unstable on (1, 1.05) and beyond 3: an interval wider than the 2 % of the scan is seen.
  const auto growth = [](double x) { return exact((x > 1 && x < 1.05) || x > 3 ? 0.1 : -0.1); };
  EXPECT_NEAR(find_limit(growth).limit, 1, width);
}

TEST(StabilitySearch, AFailureEndsStability) {
  const LimitFound found = find_limit([](double x) { return x < 0.7 ? exact(-x) : Growth{}; });
  EXPECT_NEAR(found.limit, 0.7, width);
  EXPECT_TRUE(found.fails);
}

TEST(StabilitySearch, AFailureAfterNeutralGrowthIsNoPowerLaw) {
  const LimitFound found = find_limit([](double x) { return x < 0.7 ? exact(0) : Growth{}; });
  EXPECT_NEAR(found.limit, 0.7, width);
  EXPECT_TRUE(found.fails);
}

TEST(StabilitySearch, FailingFromTheStartHasNoLimit) {
  const LimitFound found = find_limit([](double) { return Growth{}; });
  EXPECT_TRUE(std::isnan(found.limit));
  EXPECT_TRUE(found.fails);
}

TEST(StabilitySearch, GrowthThatIsCertainAtTheFirstPointGivesZero) {
  EXPECT_EQ(find_limit([](double) { return exact(1); }).limit, 0);
}

}  // namespace
}  // namespace odeum::judge::search_test
