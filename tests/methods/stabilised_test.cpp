// SPDX-License-Identifier: BSD-3-Clause
// Explicit methods with as many stages as a step needs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "odeum/control/run_method.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/methods/rkc2.hpp"
#include "odeum/methods/rkl2.hpp"

namespace odeum::tests {
namespace {

/// Heat on a rod of n inner points and length 1, whose solution from a half wave decays.
struct Rod {
  static constexpr std::size_t dimension = dynamic;
  std::size_t n;
  std::size_t size() const { return n; }
  double width() const { return 1.0 / static_cast<double>(n + 1); }
  void rhs(double, const double* y, double* dydt) const {
    const double scale = 1 / (width() * width());
    for (std::size_t i = 0; i < n; ++i) {
      const double left = i > 0 ? y[i - 1] : 0, right = i + 1 < n ? y[i + 1] : 0;
      dydt[i] = scale * (left - 2 * y[i] + right);
    }
  }
  std::vector<double> half_waves(int k) const {
    std::vector<double> y(n);
    for (std::size_t i = 0; i < n; ++i)
      y[i] = std::sin(k * std::numbers::pi * static_cast<double>(i + 1) * width());
    return y;
  }
  double eigenvalue(int k) const {
    const double s = std::sin(k * std::numbers::pi * width() / 2) / width();
    return -4 * s * s;
  }
};

template <class M>
class Stabilised : public testing::Test {};
using Methods = testing::Types<methods::rkc2, methods::rkl2>;
TYPED_TEST_SUITE(Stabilised, Methods);

// The stages that a step takes are stable where it needs them, and fewer would not be: beta(s) is
// 2/3 (s^2 - 1) for Chebyshev's polynomials and (s^2 + s - 2) / 2 for Legendre's.
TYPED_TEST(Stabilised, HasTheStagesThatAStepNeeds) {
  for (double x = 0.05; x < 5e4; x *= 1.01) EXPECT_LE(TypeParam::amplification(-x, 0), 1) << x;
  // 400 stages are the most; beyond their interval the polynomial grows.
  EXPECT_GT(TypeParam::amplification(-1e6, 0), 1);
}

TYPED_TEST(Stabilised, EndsEachStageAtItsOwnTime) {
  using Rule = std::conditional_t<std::is_same_v<TypeParam, methods::rkc2>, methods::rkc2_rule,
                                  methods::rkl2_rule>;
  for (const int count : {3, 5, 21, 101}) {
    const std::vector<StabilisedStage> stages = Rule::stages(count);
    ASSERT_EQ(stages.size(), static_cast<std::size_t>(count));
    double before = 0;
    for (const StabilisedStage& stage : stages) {
      EXPECT_GT(stage.c, before) << count;
      before = stage.c;
    }
    EXPECT_NEAR(stages.back().c, 1, 1e-12) << count;  // rounding of a hundred stages
  }
}

// A rod of 200 points: explicit Euler needs 80,400 evaluations over one unit of time.
TYPED_TEST(Stabilised, RunsStiffProblemsInFewEvaluations) {
  const Rod rod{200};
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = 1e-5;
  request.stops = {0.1};
  Guard guard(rod.n, {});
  const Guarded<Rod> guarded(rod, guard);
  const State<Rod> y0 = rod.half_waves(1);
  Outcome outcome = run_method<TypeParam>(guarded, 0, y0, request);
  guard.conclude(request, outcome);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  EXPECT_LT(outcome.counters.rhs_evaluations, 2500U);
  const double decay = std::exp(0.1 * rod.eigenvalue(1));
  // A tolerance of 1e-5 a step, some forty steps.
  for (std::size_t i = 0; i < rod.n; ++i) EXPECT_NEAR(outcome.states[i], decay * y0[i], 1e-4);
}

// From the slowest direction, along which f never leaves it.
TEST(SpectralRadius, SeesDirectionsThatTheSolutionHasNot) {
  for (const std::size_t n : {1, 2, 10, 300}) {
    const Rod rod{n};
    SpectralRadius<Rod> radius_of(rod);
    const State<Rod> y = rod.half_waves(1);
    State<Rod> f = y;
    rod.rhs(0, y.data(), f.data());
    const double radius = radius_of(0, y, f), exact = -rod.eigenvalue(static_cast<int>(n));
    EXPECT_GE(radius, exact) << n;
    // Its margin is a fifth.
    EXPECT_LE(radius, 1.21 * exact) << n;
  }
}

}  // namespace
}  // namespace odeum::tests
