// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/order_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/error_points.hpp"

namespace odeum::judge::order_fit_test {
namespace {

TEST(OrderFit, TellsNeighbouringOrdersApart) {
  const auto points = ladder(2, 10, [](double h) { return 0.1 * h * h * (1 + h); });
  EXPECT_EQ(fit_fixed(points, 2).verdict, Verdict::confirmed);
  EXPECT_EQ(fit_fixed(points, 1).verdict, Verdict::higher);
  EXPECT_EQ(fit_fixed(points, 3).verdict, Verdict::lower);
  EXPECT_NEAR(fit_fixed(points, 2).order, 2, 0.05);  // the window's slopes agree to 0.1
}

TEST(OrderFit, NeedsFourPointsClearOfRounding) {
  const auto points =
      ladder(2, 8, [](double h) { return std::max(std::pow(h, 8), 3 * half_epsilon); });
  EXPECT_EQ(fit_fixed(points, 8).verdict, Verdict::confirmed);
  const std::vector<ErrorPoint> finest(points.begin() + 3, points.end());
  EXPECT_EQ(fit_fixed(finest, 8).verdict, Verdict::undetermined);
}

TEST(OrderFit, AnErrorThatStopsFallingAboveRoundingIsAFloor) {
  const OrderFit fit = fit_fixed(ladder(2, 10, [](double h) { return h * h + 1e-3; }), 2);
  EXPECT_EQ(fit.verdict, Verdict::floors);
  EXPECT_NEAR(fit.floor, 1e-3, 1e-4);  // the median from where the errors stop falling
}

// Slopes that agree at coarse steps do not count where finer ones, clear of rounding, differ.
TEST(OrderFit, AStretchBeforeConvergenceIsNoOrder) {
  const auto points = ladder(1.26, 18, [](double h) {
    return h > 0.1 ? 1e4 * std::pow(h, 12) : 1e-8 * std::pow(h / 0.1, 3 + 40 * (0.1 - h));
  });
  EXPECT_NE(fit_fixed(points, 8).verdict, Verdict::higher);
  EXPECT_NE(fit_fixed(points, 12).verdict, Verdict::confirmed);
}

// Two terms of which the second dominates at every step fit as one term of another order.
TEST(OrderFit, AHigherOrderIsNotOneLowerWithALargeSecondTerm) {
  const auto points = ladder(1.06, 40, [](double h) { return std::pow(h, 6) * 1e-3; });
  EXPECT_EQ(fit_fixed(points, 5).verdict, Verdict::higher);
}

// With closely spaced steps the noise of the errors dominates the slopes between neighbours.
TEST(OrderFit, LooksAtSlopesOverStepsFarEnoughApart) {
  int n = 0;
  const auto points = ladder(1.05, 24, [&](double h) {
    return std::pow(h, 4) * 1e-4 * (1 + 0.02 * (n++ % 2));  // a slope of 0.4 between neighbours
  });
  EXPECT_EQ(fit_fixed(points, 4).verdict, Verdict::confirmed);
}

// Errors below rounding do not matter, however small by chance.
TEST(OrderFit, ALuckyEndSaysNothing) {
  auto points = ladder(1.12, 30, [](double h) { return std::pow(h, 9) * 1e-5; });
  int k = 0;
  for (ErrorPoint& point : points)  // scatters within a decade of 1e-18
    if (point.error < 1e-18) point.error = 1e-18 * (1 + 3 * (k++ % 3));
  points.back().error = 1e-20;
  const OrderFit fit = fit_fixed(points, 9);
  EXPECT_EQ(fit.verdict, Verdict::confirmed) << fit.reason;
}

// A method that is unstable until its steps are tiny grows an error that may lie on a straight line
// of negative slope: no order was measured.
TEST(OrderFit, ErrorsThatGrowAsTheStepShrinksAreNoConvergence) {
  const OrderFit below = fit_fixed(ladder(2, 8, [](double h) { return 1e-6 / h; }), 8);
  EXPECT_EQ(below.verdict, Verdict::floors);
  auto recovers = ladder(2, 8, [](double h) { return 1e-6 / h; });
  recovers.back().error = 1e-9;
  EXPECT_EQ(fit_fixed(recovers, 8).verdict, Verdict::undetermined);
}

TEST(OrderFit, ABlowUpSaysNothingOfAnOrder) {
  const OrderFit fit = fit_fixed(ladder(2, 8, [](double h) { return std::pow(h, -20) * 1e10; }), 8);
  EXPECT_EQ(fit.verdict, Verdict::undetermined);
  EXPECT_EQ(fit.points, 0U);
}

// Two tolerances that lead to the same steps are one measurement.
TEST(OrderFit, TheSameStepsTwiceAreOnePoint) {
  auto points = ladder(2, 5, [](double h) { return std::pow(h, 3); });
  points.insert(points.begin() + 2, points[2]);
  points[2].error *= 1e3;
  const OrderFit fit = fit_fixed(points, 3);
  EXPECT_EQ(fit.verdict, Verdict::confirmed);
  EXPECT_EQ(fit.points, 5U);
  // Exact solves are exact at each tolerance, for any number of steps.
  const std::vector<ErrorPoint> exact(
      6, {.step = 0.5, .error = 1e-16, .steps = 20, .rounding_unit = half_epsilon});
  EXPECT_EQ(fit_fixed(exact, 3).verdict, Verdict::higher);
}

// The first two terms of the error nearly cancel: slopes reach the order late.
TEST(OrderFit, SlopesThatStillMoveAreExplainedByTheNextTerm) {
  const auto near_cancellation = [](double h) {
    return std::abs(1e-4 * std::pow(h, 5) * (1 - 3.2 * h));
  };
  const OrderFit fit = fit_fixed(ladder(1.26, 10, near_cancellation), 5);
  EXPECT_EQ(fit.verdict, Verdict::confirmed);
  EXPECT_NEAR(fit.order, 5, 0.02);  // the error has two terms, and the fit both
  // It must not be fitted as another order.
  EXPECT_NE(fit_fixed(ladder(1.26, 10, near_cancellation), 6).verdict, Verdict::confirmed);
  EXPECT_NE(fit_fixed(ladder(1.26, 10, near_cancellation), 4).verdict, Verdict::confirmed);
}

// A term of lower order that takes over is not a next term.
TEST(OrderFit, ALowerOrderThatTakesOverIsNotExplainedAway) {
  const auto spoilt = [](double h) { return std::pow(h, 5) + 0.02 * std::pow(h, 3); };
  EXPECT_EQ(fit_fixed(ladder(1.26, 20, spoilt), 5).verdict, Verdict::lower);
}

// A floor is one although coarser steps show the order: rounding is known beforehand, and errors a
// hundred times as large are none.
TEST(OrderFit, AFloorBelowAGoodWindowIsSeen) {
  const auto with_floor = [](double floor, double growth) {
    return fit_fixed(
        ladder(std::sqrt(2), 20,
               [=](double h) { return 0.1 * std::pow(h, 4) + floor * std::pow(0.01 / h, growth); }),
        4);
  };
  const OrderFit constant = with_floor(1e-10, 0);
  EXPECT_EQ(constant.verdict, Verdict::floors);
  EXPECT_NEAR(constant.floor, 1e-10, 1e-11);
  EXPECT_NEAR(constant.order, 4, 0.1);           // before the floor
  EXPECT_NEAR(constant.floor_step, 5e-3, 5e-3);  // 0.1 h^4 = 1e-10 at 5.6e-3
  EXPECT_NE(constant.floor_scale.find("at all steps"), std::string::npos) << constant.floor_scale;
  const OrderFit noise = with_floor(1e-11, 0.5);
  EXPECT_EQ(noise.verdict, Verdict::floors);
  EXPECT_NE(noise.floor_scale.find("root of the number"), std::string::npos) << noise.floor_scale;
  const OrderFit each_step = with_floor(1e-11, 1);
  EXPECT_NE(each_step.floor_scale.find("to the number"), std::string::npos)
      << each_step.floor_scale;
  // Ten times rounding at most, which sound solvers show.
  EXPECT_EQ(with_floor(2e-14, 0).verdict, Verdict::confirmed) << with_floor(2e-14, 0).reason;
}

// A lower order takes over at fine steps: they decide.
TEST(OrderFit, AnOrderThatFinerStepsDenyIsNotConfirmed) {
  const auto late = [](int count) {
    return fit_fixed(
        ladder(std::sqrt(2), count, [](double h) { return std::pow(h, 4) + 1e-5 * h * h; }), 4);
  };
  EXPECT_NE(late(16).verdict, Verdict::confirmed) << late(16).reason;
  EXPECT_EQ(late(26).verdict, Verdict::lower) << late(26).reason;
  EXPECT_NEAR(late(26).order, 2, 0.15);
}

// Slopes that were measured with wrong methods, from the claimed order to the finest steps: fits
// through all of them, or of two terms, confirmed the claim.
TEST(OrderFit, SlopesThatFallAwayFromTheClaimDoNotConfirmIt) {
  const auto fit = [](double claimed, const std::vector<double>& finest, double ratio) {
    std::vector<double> slopes(3, claimed);
    slopes.insert(slopes.end(), finest.begin(), finest.end());
    double error = 1e-2;
    auto points = ladder(ratio, static_cast<int>(slopes.size()) + 1, [&](double) { return error; });
    for (std::size_t i = 1; i < points.size(); ++i)
      points[i].error = error *= std::pow(ratio, -slopes[i - 1]);
    return fit_fixed(points, claimed);
  };
  for (const double ratio : {1.26, std::sqrt(2), 2.0}) {
    for (const auto& finest : std::vector<std::vector<double>>{
             {3.71, 3.42, 3.17}, {3.83, 3.65, 3.29}, {4.05, 3.71, 2.78}, {3.94, 3.84, 3.74}})
      EXPECT_NE(fit(4, finest, ratio).verdict, Verdict::confirmed) << ratio << ' ' << finest.back();
    EXPECT_NE(fit(2, {2.0, 1.6, 1.4}, ratio).verdict, Verdict::confirmed) << ratio;
    // What right methods show: a scatter, and slopes that come from below.
    EXPECT_EQ(fit(4, {3.95, 4.04, 3.93}, ratio).verdict, Verdict::confirmed) << ratio;
    EXPECT_EQ(fit(4, {3.9, 3.95, 3.98}, ratio).verdict, Verdict::confirmed) << ratio;
  }
}

// Slopes that have settled beside the claim, nearer to it than to any other order.
TEST(OrderFit, SlopesNearTheClaimDenyNothing) {
  const auto slope = [](double p) {
    return fit_fixed(ladder(1.26, 12, [p](double h) { return 1e-2 * std::pow(h, p); }), 5);
  };
  EXPECT_EQ(slope(5.4).verdict, Verdict::undetermined);
  EXPECT_EQ(slope(5.6).verdict, Verdict::higher);
  EXPECT_EQ(slope(4.4).verdict, Verdict::lower);
}

// Points that may be rounding are used where they confirm, and deny nothing.
TEST(OrderFit, ErrorsNearRoundingDenyNothing) {
  const auto points = ladder(1.26, 22, [](double h) {
    return std::max(std::pow(h, 9) * 1e-3, 40 * half_epsilon * std::sqrt(10 / h));
  });
  EXPECT_EQ(fit_fixed(points, 9).verdict, Verdict::confirmed);
}

TEST(OrderFit, ExactIsWhatIsRoundingAtTheCoarsestStepsToo) {
  const auto rounding = [](double h) { return half_epsilon * std::sqrt(10 / h); };
  EXPECT_EQ(fit_fixed(ladder(2, 8, rounding), 4).verdict, Verdict::higher);
  const auto inexact = [&](double h) { return 1e-11 * h * h + rounding(h); };
  EXPECT_NE(fit_fixed(ladder(2, 8, inexact), 4).verdict, Verdict::higher);
}

// Four close points that agree by chance are not a window: it has a minimal width.
TEST(OrderFit, AWindowSpansSteps) {
  const auto points = ladder(1.05, 4, [](double h) { return std::pow(h, 4); });
  EXPECT_NE(fit_fixed(points, 4).verdict, Verdict::confirmed);
  const auto wide = ladder(1.05, 8, [](double h) { return std::pow(h, 4); });
  EXPECT_EQ(fit_fixed(wide, 4).verdict, Verdict::confirmed);
}

TEST(OrderFit, AScatterThatLeavesTheClaimOpenIsNotLower) {
  int k = 0;
  const auto points =
      ladder(2, 5, [&](double h) { return std::pow(h, 3.7) * (k++ % 2 ? 1.15 : 0.85); });
  const OrderFit fit = fit_order(
      points, 4, {.order = 0.15, .apart = 0.3, .settled = 0.5, .stray = 2, .whole = 0.15});
  EXPECT_EQ(fit.verdict, Verdict::undetermined) << fit.order;
  EXPECT_EQ(fit.why, NoOrder::wide_interval);
  EXPECT_LT(fit.low, 4);
  EXPECT_GT(fit.high, 4);
}

}  // namespace
}  // namespace odeum::judge::order_fit_test
