// SPDX-License-Identifier: BSD-3-Clause
// Explicit methods with as many stages as a step needs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "odeum/control/run_method.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/methods/rkc2.hpp"
#include "odeum/methods/rkl2.hpp"
#include "odeum/methods/rock2.hpp"
#include "odeum/methods/rock4.hpp"

namespace odeum::tests::stabilised_test {
namespace {

template <class Rule>
Rule rule_of(const StabilisedMethod<Rule>&);
template <class Method>
using RuleOf = decltype(rule_of(Method()));

/// The coefficients of a step.
struct Coefficients {
  std::vector<StabilisedStage> stages;
  bool with_start = true;  ///< the start of the step has the weight 1 - mu - nu
  std::optional<LastStages> last{};
};
template <class Method>
Coefficients coefficients_of(int count) {
  using Rule = RuleOf<Method>;
  Coefficients all{Rule::stages(count), !Rule::last_two_only};
  if constexpr (requires { Rule::last_stages(count); }) all.last = Rule::last_stages(count);
  return all;
}

using Complex = std::complex<double>;
Complex growth(const Coefficients& of, Complex z) {
  Complex before = 1, now = 1.0 + of.stages[0].slope * z;
  for (std::size_t j = 1; j < of.stages.size(); ++j) {
    const StabilisedStage& s = of.stages[j];
    const double rest = of.with_start ? 1 - s.mu - s.nu : 0;
    const auto next = rest + s.mu * now + s.nu * before + z * (s.slope * now + s.first_slope);
    before = std::exchange(now, next);
  }
  if (!of.last) return now;
  std::array<Complex, 5> k, y;
  for (std::size_t i = 0; i < 5; ++i) {
    y[i] = now;
    for (std::size_t j = 0; j < i; ++j) y[i] += of.last->a[i][j] * k[j];
    k[i] = z * y[i];
  }
  return y[4];
}

/// The largest difference of the coefficients of R(z) up to z^order from those of e^z, by Cauchy's
/// formula on a circle.
double order_defect(const Coefficients& of, int order) {
  constexpr int points = 64;
  constexpr double radius = 0.5;
  std::vector<double> found(static_cast<std::size_t>(order) + 1);
  for (int i = 0; i < points; ++i) {
    const auto z = std::polar(radius, 2 * std::numbers::pi * i / points);
    Complex value = growth(of, z) / double{points};
    for (double& c : found) {
      c += value.real();
      value /= z;
    }
  }
  double factorial = 1, worst = 0;
  for (int k = 0; k <= order; ++k) {
    if (k > 0) factorial *= k;
    worst = std::max(worst, std::abs(found[static_cast<std::size_t>(k)] - 1 / factorial));
  }
  return worst;
}

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
using Methods = testing::Types<methods::rkc2, methods::rkl2, methods::rock2, methods::rock4>;
TYPED_TEST_SUITE(Stabilised, Methods);

// The stages that a step takes are stable where it needs them, and fewer would not be: beta(s) is
// 2/3 (s^2 - 1) for Chebyshev's polynomials and (s^2 + s - 2) / 2 for Legendre's.
TYPED_TEST(Stabilised, HasTheStagesThatAStepNeeds) {
  for (double x = 0.05; x < 5e4; x *= 1.01) EXPECT_LE(TypeParam::amplification(-x, 0), 1) << x;
  // 400 stages are the most; beyond their interval the polynomial grows.
  EXPECT_GT(TypeParam::amplification(-1e6, 0), 1);
}

// A spectral radius may overflow, and a product with a step be no number.
TYPED_TEST(Stabilised, HasStagesForAnyNumber) {
  using Rule = RuleOf<TypeParam>;
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, -1.0, 1e300, infinite, -infinite, std::nan("")}) {
    EXPECT_GE(Rule::count_for(x), 2) << x;
    EXPECT_LE(Rule::count_for(x), Rule::most_stages) << x;
  }
}

TYPED_TEST(Stabilised, EndsEachStageAtItsOwnTime) {
  for (const int count : {5, 21, 101}) {
    const Coefficients all = coefficients_of<TypeParam>(count);
    const std::vector<StabilisedStage>& stages = all.stages;
    ASSERT_EQ(stages.size() + (all.last ? 4 : 0), static_cast<std::size_t>(count));
    if (all.last) {
      EXPECT_NEAR(all.last->c[4], 1, 1e-12);
      continue;
    }
    double before = 0;
    for (const StabilisedStage& stage : stages) {
      EXPECT_GT(stage.c, before) << count;
      before = stage.c;
    }
    EXPECT_NEAR(stages.back().c, 1, 1e-12) << count;  // rounding of a hundred stages
  }
}

// Whatever the number of stages, R(z) is e^z up to its order and no further.
TYPED_TEST(Stabilised, HasItsOrderWithAnyNumberOfStages) {
  constexpr double rounding = 1e-12;  // of recurrences
  constexpr int order = TypeParam::info.order;
  for (const int count : {5, 7, 9, 15, 41, 101, 399}) {
    const Coefficients all = coefficients_of<TypeParam>(count);
    EXPECT_LE(order_defect(all, order), rounding) << count;
    EXPECT_GT(order_defect(all, order + 1), 1e-4) << count;
  }
}

TYPED_TEST(Stabilised, NoCoefficientMayChange) {
  constexpr int count = 11;
  constexpr double change = 1e-6, seen = 1e-10;
  const Coefficients sound = coefficients_of<TypeParam>(count);
  const auto defect = [](const Coefficients& c) { return order_defect(c, TypeParam::info.order); };
  for (std::size_t j = 0; j < sound.stages.size(); ++j)
    for (double StabilisedStage::*const member :
         {&StabilisedStage::mu, &StabilisedStage::nu, &StabilisedStage::slope,
          &StabilisedStage::first_slope}) {
      // The first stage has the slope alone, and before the second is the start of the step.
      if (sound.stages[j].*member == 0 || (j == 0 && member != &StabilisedStage::slope)) continue;
      if (j == 1 && member == &StabilisedStage::nu && sound.with_start) continue;
      Coefficients mutant = sound;
      mutant.stages[j].*member *= 1 + change;
      EXPECT_GT(defect(mutant), seen) << "stage " << j;
    }
  if (!sound.last) return;
  for (std::size_t i = 1; i < 5; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (sound.last->a[i][j] == 0) continue;
      Coefficients mutant = sound;
      mutant.last->a[i][j] *= 1 + change;
      EXPECT_GT(defect(mutant), seen) << "last stage " << i << ", " << j;
    }
}

// The published lengths of the intervals, 0.81 s^2 (here 0.807) and 0.35 s^2, with |R| <= 0.95 but
// near 0; rkc2 has 0.65 s^2.
template <class Method>
void expect_interval(double factor, double less) {
  for (const int count : {5, 6, 8, 13, 30, 77, 200, 400}) {
    const Coefficients all = coefficients_of<Method>(count);
    const double length = factor * count * count - less;
    EXPECT_EQ(RuleOf<Method>::count_for(length - 1e-6), count);
    for (double x = 1; x < length; x += 0.02 * std::sqrt(x * length) / count)
      ASSERT_LE(std::abs(growth(all, -x)), 0.9505) << count << " stages at " << -x;
    // A fifth further it is unstable.
    EXPECT_GT(std::abs(growth(all, -1.2 * length - 1)), 1) << count;
  }
}
TEST(Rock2, HasThePublishedInterval) { expect_interval<methods::rock2>(0.807, 1.2); }
TEST(Rock4, HasThePublishedInterval) { expect_interval<methods::rock4>(0.35, 2.9); }

TEST(Rock4, CoefficientsAreFoundForEveryDegree) {
  for (int count = 5; count <= 80; ++count)
    EXPECT_TRUE(methods::rock4_rule::computed(count).found) << count;
}

// Without the weight, Chebyshev's own polynomials; with it, orthogonal ones.
TEST(WeightedChebyshev, GivesOrthogonalPolynomials) {
  const OrthogonalRecurrence chebyshev =
      weighted_chebyshev(std::array<std::complex<double>, 0>{}, 6);
  for (std::size_t j = 0; j < 6; ++j) {
    EXPECT_NEAR(chebyshev.a[j], 0, 1e-15);
    EXPECT_NEAR(chebyshev.b[j], j == 0 ? 0 : j == 1 ? 0.5 : 0.25, 1e-15);
  }
  const std::array<std::complex<double>, 1> zeros{{{0.4, 0.7}}};
  const auto all = weighted_chebyshev(zeros, 5);
  OrthogonalRecurrence two = all, four = all;
  two.a.resize(2), two.b.resize(2), four.a.resize(4), four.b.resize(4);
  double sum = 0, size = 0;
  for (int i = 0; i < 100; ++i) {
    const double x = std::cos((i + 0.5) * std::numbers::pi / 100);
    const double w = value_of_pairs(zeros, x)[0];
    const double part = w * w * value_of(two, x)[0] * value_of(four, x)[0];
    sum += part;
    size += std::abs(part);
  }
  EXPECT_LE(std::abs(sum), 1e-13 * size);
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

/// y' = A y of two unknowns with the entries of A.
struct Pair {
  static constexpr std::size_t dimension = 2;
  std::array<double, 4> a{};
  Sparsity pattern = banded_sparsity(2, 1, 1);
  mutable int evaluations = 0;
  void rhs(double, const double* y, double* f) const {
    ++evaluations;
    f[0] = a[0] * y[0] + a[1] * y[1];
    f[1] = a[2] * y[0] + a[3] * y[1];
  }
  const Sparsity* sparsity() const { return &pattern; }
  void jacobian_entries(double, const double*, double* values) const {
    std::copy(a.begin(), a.end(), values);
  }
};

TEST(SpectralRadius, TakesTheNormOfAJacobianWhereThatIsNearIt) {
  const State<Pair> y{1, 1};
  State<Pair> f{};
  const Pair diffusion{{-2, 1, 1, -2}};
  EXPECT_EQ(SpectralRadius<Pair>(diffusion)(0, y, f), 3);
  EXPECT_EQ(diffusion.evaluations, 0);
  const Pair far_above{{-1, 100, 0, -2}};
  far_above.rhs(0, y.data(), f.data());
  // The margin of the power method.
  EXPECT_NEAR(SpectralRadius<Pair>(far_above)(0, y, f), 2 * 1.2, 0.05);
}

}  // namespace
}  // namespace odeum::tests::stabilised_test
