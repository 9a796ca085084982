// SPDX-License-Identifier: BSD-3-Clause
// Measured errors that were taken for another order, or for a floor.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/judge/fit_parts.hpp"
#include "odeum/judge/order_fit.hpp"
#include "support/error_points.hpp"

namespace odeum::judge::order_denial_test {
namespace {

/// Errors of runs over a horizon of 10 on a solution of size 5.
std::vector<ErrorPoint> measured(const std::vector<double>& steps,
                                 const std::vector<double>& errors) {
  std::vector<ErrorPoint> points;
  for (std::size_t i = 0; i < steps.size(); ++i)
    points.push_back({.step = 10 / steps[i],
                      .error = errors[i],
                      .steps = steps[i],
                      .rounding_unit = half_epsilon / 10,
                      .scale = 5});
  return points;
}

// Measured errors whose slopes agree with each other within a window and fall, or rise, from each
// to the next: extrapolation of order 12 on the overdamped oscillator was `higher` 14.8
// by 15.3 14.6 14.4, and sdirk4 on medical Akzo Nobel's problem `lower` 3.54
// by 3.38 3.47 3.55 3.61, where four and eight times as many steps show 3.83 and 3.91.
TEST(OrderFit, SlopesThatMoveTowardsTheClaimDoNotDenyIt) {
  const OrderFit falling =
      fit_fixed(measured({10, 12, 14, 16, 18, 20},
                         {5.43e-7, 1.37e-10, 7.06e-12, 9.16e-13, 1.64e-13, 3.61e-14}),
                12);
  EXPECT_EQ(falling.verdict, Verdict::undetermined) << falling.order;
  EXPECT_NE(falling.reason.find("move towards 12"), std::string::npos) << falling.reason;
  const OrderFit rising = fit_fixed(
      measured({160, 225, 320, 455, 640}, {5.39e-7, 1.703e-7, 5.025e-8, 1.443e-8, 4.202e-9}), 4);
  EXPECT_EQ(rising.verdict, Verdict::undetermined) << rising.order;
  // Slopes of 14.0 8.06 7.77 8.06 8.24, which pass the claim of 9 at coarse steps and return to it:
  // verner98 on y' = y (1 - y).
  const OrderFit from_below =
      fit_fixed(measured({3, 6, 9, 12, 15, 18},
                         {1.598e-6, 9.574e-11, 3.650e-12, 3.902e-13, 6.460e-14, 1.437e-14}),
                9);
  EXPECT_EQ(from_below.verdict, Verdict::undetermined) << from_below.order;
  // They settle at another order, or move away from the claim: denied as before.
  const auto settles = [](double p, double by) {
    return fit_fixed(
        ladder(1.26, 12,
               [=](double h) { return 1e-2 * std::pow(h, p) * std::exp(by * std::pow(h, 2)); }),
        4);
  };
  EXPECT_EQ(settles(3, 0.5).verdict, Verdict::lower) << "slopes of 3.25 to 3, away from 4";
  EXPECT_EQ(settles(3, -0.5).verdict, Verdict::lower) << "slopes of 2.75 to 3, which settle there";
  EXPECT_EQ(settles(5, 0.5).verdict, Verdict::higher) << "slopes of 5.25 to 5, which settle there";
}

// Measured errors whose slopes lie between whole orders, over steps too few to tell: Heun's method
// on the Pleiades was `higher` 2.50, and is confirmed at finer steps; verner98 on Lorenz's
// attractor `higher` 11.4, the last slope before rounding.
TEST(OrderFit, SlopesBetweenWholeOrdersDenyNothingUnlessTheyLast) {
  const OrderFit heun = fit_fixed(
      measured({3072, 4344, 6144, 8688, 12288}, {0.7205, 0.3260, 0.1382, 0.05750, 0.02421}), 2);
  EXPECT_EQ(heun.verdict, Verdict::undetermined) << heun.order;
  EXPECT_EQ(heun.why, NoOrder::unsettled) << heun.reason;
  const OrderFit verner =
      fit_fixed(measured({128, 161, 203, 256, 323, 406, 512},
                         {1.416e-3, 9.283e-5, 9.394e-6, 6.987e-7, 5.264e-8, 3.943e-9, 2.625e-10}),
                9);
  EXPECT_EQ(verner.verdict, Verdict::undetermined) << verner.order;
  // A slope of 2.5 that lasts over a factor of eight in the steps is what a method shows whose
  // order is reduced.
  const auto constant = [](int count) {
    return fit_fixed(ladder(std::sqrt(2), count, [](double h) { return std::pow(h, 2.5); }), 4);
  };
  EXPECT_EQ(constant(5).verdict, Verdict::undetermined) << "a factor of 4";
  EXPECT_EQ(constant(7).verdict, Verdict::lower) << "a factor of 8";
  // A whole order is one over fewer.
  EXPECT_EQ(
      fit_fixed(ladder(std::sqrt(2), 5, [](double h) { return std::pow(h, 3.1); }), 4).verdict,
      Verdict::lower);
}

// A method of order 4 that claims 5, on the Pleiades, had slopes of 4.33, 4.54 and 4.59 and was
// confirmed, since two terms through its errors gave p = 4.84.
TEST(OrderFit, TwoTermsBelowTheClaimConfirmNothing) {
  const auto two_terms = [](double p) {
    return fit_fixed(
        ladder(1.26, 8, [p](double h) { return 1e-2 * std::pow(h, p) * (1 - 1.3 * h); }), 5);
  };
  EXPECT_EQ(two_terms(4.84).verdict, Verdict::undetermined) << two_terms(4.84).reason;
  EXPECT_EQ(two_terms(4.95).verdict, Verdict::confirmed) << two_terms(4.95).reason;
}

// dormand_prince54 to tolerances from 1e-3 to 1e-10 on the Pleiades was `higher`, 6.23: its leading
// term is small, and its claim is to fall with order 5 at least.
TEST(OrderFit, AnAdaptiveRunIsHeldToAtLeastItsOrder) {
  const auto points =
      measured({49, 73, 103, 154, 235, 360, 560, 889},
               {0.1716, 0.01719, 1.891e-3, 2.113e-4, 1.968e-5, 8.893e-7, 4.655e-8, 2.504e-9});
  const auto adaptive = [&](double claimed) {
    return fit_order(points, claimed, adaptive_tolerance(claimed));
  };
  EXPECT_EQ(adaptive(5).verdict, Verdict::confirmed) << adaptive(5).reason;
  EXPECT_NE(adaptive(5).reason.find("at least the 5"), std::string::npos) << adaptive(5).reason;
  EXPECT_NE(adaptive(8).verdict, Verdict::confirmed) << adaptive(8).reason;
  EXPECT_NE(fit_fixed(points, 5).verdict, Verdict::confirmed) << "at fixed steps it is the order";
}

// tsitouras54 on the stiff elastic pendulum: the finest two steps differ by 6 %, and their errors
// by rounding, so that the reason named a slope of 0.51 where the errors fall with 5.3.
TEST(OrderFit, TheSlopeAtTheFinestStepsIsOverStepsFarEnoughApart) {
  const auto points = measured({2560, 2710, 2880, 3050, 3230, 3420},
                               {4.69e-12, 3.53e-12, 2.65e-12, 1.94e-12, 1.288e-12, 1.251e-12});
  EXPECT_LT(local_slope(points[4], points[5]), 1);
  EXPECT_NEAR(local_slope_to(points, 5), 5, 1.1);
  EXPECT_EQ(local_slope_to(points, 1), local_slope(points[0], points[1])) << "none is far enough";
}

TEST(OrderFit, SaysWhyThereIsNone) {
  const auto power = [](double p, int count) {
    return ladder(1.26, count, [p](double h) { return 1e-2 * std::pow(h, p); });
  };
  EXPECT_EQ(fit_fixed(power(5, 12), 5).why, NoOrder::none);
  EXPECT_EQ(fit_fixed(power(3, 12), 5).why, NoOrder::none) << "another order is one";
  EXPECT_EQ(fit_fixed(power(5.4, 12), 5).why, NoOrder::unsettled);
  EXPECT_EQ(fit_fixed(power(5, 3), 5).why, NoOrder::few_solved);
  const auto falls_to_rounding =
      ladder(2, 8, [](double h) { return std::max(std::pow(h, 16), half_epsilon); });
  EXPECT_EQ(fit_fixed(falls_to_rounding, 16).why, NoOrder::few_points);
  EXPECT_EQ(fit_fixed(ladder(2, 8, [](double) { return std::nan(""); }), 4).why,
            NoOrder::few_solved);
  const auto late =
      ladder(std::sqrt(2), 16, [](double h) { return std::pow(h, 4) + 1e-5 * h * h; });
  EXPECT_EQ(fit_fixed(late, 4).why, NoOrder::unsettled) << fit_fixed(late, 4).reason;
}

// seulex on Prothero and Robinson's problem: the error changes its sign at 5120 steps, and falls
// from both sides of that; three points made a floor of it.
TEST(OrderFit, AnErrorThatPassesThroughZeroIsNoFloor) {
  const OrderFit fit =
      fit_fixed(measured({1280, 1810, 2560, 3620, 5120, 7240, 10240},
                         {4.54e-11, 3.33e-10, 2.32e-10, 7.02e-11, 2.47e-12, 1.29e-11, 7.23e-12}),
                5);
  EXPECT_EQ(fit.verdict, Verdict::undetermined) << fit.reason;
  // Three that stay where they are, or rise, make one.
  const OrderFit stays = fit_fixed(measured({640, 1280, 2560, 5120, 10240, 20480},
                                            {1e-6, 6.25e-8, 3.9e-9, 2.47e-12, 2.9e-12, 2.6e-12}),
                                   4);
  EXPECT_EQ(stays.verdict, Verdict::floors) << stays.reason;
}

OrderFit fit_adaptive(const std::vector<ErrorPoint>& points, double claimed) {
  return fit_order(points, claimed, adaptive_tolerance(claimed));
}

// A control with a wrong exponent leaves the order in the steps taken as it is.
TEST(OrderDenial, AControlThatRejectsOverAThirdOfItsTriesConfirmsNothing) {
  auto points = ladder(1.6, 8, [](double h) { return 1e-3 * std::pow(h, 5); });
  const auto reject = [&](double share) {
    for (ErrorPoint& point : points) point.rejected = share / (1 - share) * point.steps;
  };
  reject(0.31);  // the most that sound ones were seen to
  EXPECT_EQ(fit_adaptive(points, 5).verdict, Verdict::confirmed);
  reject(0.42);
  const OrderFit fit = fit_adaptive(points, 5);
  EXPECT_EQ(fit.verdict, Verdict::undetermined);
  EXPECT_EQ(fit.why, NoOrder::rejections) << fit.reason;
  EXPECT_NEAR(fit.order, 5, 1e-9);
  // Nor where the first two terms of the error confirm, as of a fixed step.
  auto moving = ladder(1.12, 9, [](double h) { return 1e-3 * std::pow(h, 5) * (1 - 1.5 * h); });
  FitTolerance strict = fixed_step_tolerance(5);
  strict.at_least = true;
  const OrderFit two_terms = fit_order(moving, 5, strict);
  EXPECT_NE(two_terms.reason.find("two terms"), std::string::npos) << two_terms.reason;
  for (ErrorPoint& point : moving) point.rejected = point.steps;
  EXPECT_EQ(fit_order(moving, 5, strict).why, NoOrder::rejections);
  // At one tolerance alone it says nothing, nor at a fixed step.
  points.back().rejected = 0;
  EXPECT_EQ(fit_adaptive(points, 5).verdict, Verdict::confirmed);
  points.back().rejected = points.back().steps;
  EXPECT_EQ(fit_fixed(points, 5).verdict, Verdict::confirmed);
}

TEST(OrderDenial, TolerancesThatDoNotResolveTheSolutionShowNoFloor) {
  const auto level = [](double size) {
    return ladder(1.8, 6, [size](double h) { return size * (1 + 0.01 * h); });
  };
  EXPECT_EQ(fit_adaptive(level(0.8), 1).verdict, Verdict::undetermined);
  EXPECT_EQ(fit_adaptive(level(0.01), 1).verdict, Verdict::floors);
  EXPECT_EQ(fit_fixed(level(0.8), 1).verdict, Verdict::floors);
}

// An error that passes through zero, and four slopes after it.
TEST(OrderDenial, ADipOfTheErrorIsNoLowerOrder) {
  std::vector<double> steps{0.4, 0.3, 0.22, 0.16, 0.12, 0.09, 0.07, 0.055, 0.042, 0.033};
  std::vector<ErrorPoint> points = ladder(1.3, 10, [](double) { return 0.0; });
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double h = steps[k];
    points[k].step = h, points[k].steps = 10 / h;
    // The order is 5.5 down to the sixth; then errors are smaller by chance, and from there on of
    // order 3.5.
    points[k].error =
        k < 6 ? 0.01 * std::pow(h, 5.5) : 0.01 * std::pow(0.09, 5.5) / 30 * std::pow(h / 0.07, 3.5);
  }
  const OrderFit fit = fit_adaptive(points, 5);
  EXPECT_EQ(fit.verdict, Verdict::undetermined) << fit.reason;
}

}  // namespace
}  // namespace odeum::judge::order_denial_test
