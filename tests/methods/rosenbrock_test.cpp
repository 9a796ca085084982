// SPDX-License-Identifier: BSD-3-Clause
// Linearly implicit methods: measured orders, also on non-autonomous problems.
#include <gtest/gtest.h>

#include "odeum/methods/rodas4.hpp"
#include "odeum/methods/rodas5p.hpp"
#include "odeum/methods/ros2.hpp"
#include "odeum/methods/ros3p.hpp"
#include "odeum/methods/rosenbrock_euler.hpp"
#include "odeum/methods/seulex.hpp"
#include "support/implicit_stage.hpp"

namespace odeum::tests::rosenbrock_test {
namespace {

template <class M>
class LinearlyImplicit : public testing::Test {};
using Methods = testing::Types<methods::rosenbrock_euler, methods::ros2, methods::ros3p,
                               methods::rodas4, methods::rodas5p>;
TYPED_TEST_SUITE(LinearlyImplicit, Methods);

TYPED_TEST(LinearlyImplicit, HasItsOrder) {
  const double p = TypeParam::info.order;
  const std::uint64_t steps = p >= 5 ? 40 : 160;
  // As for implicit methods; what rodas5p does on linear problems, see below.
  EXPECT_NEAR((measured_order<TypeParam, DrivenDecay>(steps)), p, 0.25);
  EXPECT_NEAR((measured_order<TypeParam, AnalyticLogistic>(p >= 5 ? 10 : steps)), p, 0.25);
  if (p < 5) {
    EXPECT_NEAR((measured_order<TypeParam, LinearOscillator>(steps)), p, 0.25);
  }
}

TEST(Rodas5p, HasOrderSixOnLinearProblems) {
  EXPECT_NEAR((measured_order<methods::rodas5p, LinearOscillator>(16)), 6, 0.35);
}

/// The driven problem without its df/dt.
struct Silent : DrivenDecay {
  void time_derivative(double, const double*, double* dfdt) const { dfdt[0] = dfdt[1] = 0; }
};

TEST(Rosenbrock, NeedsTheTimeDerivative) {
  EXPECT_LT((measured_order<methods::rodas4, Silent>(160)), 2.5);
  EXPECT_LT((measured_order<methods::rodas5p, Silent>(160)), 2.5);
}

TEST(Rosenbrock, AnInexactJacobianCostsOrder) {
  // Differences have an error of 1e-8 in J, which no iteration corrects: the conditions that
  // involve J hold only to that. Coarse steps still show the order.
  EXPECT_LT((measured_order<methods::rodas4, Logistic>(160)), 3.5);
  EXPECT_NEAR((measured_order<methods::rodas4, Logistic>(5)), 4, 0.4);
}

TEST(Rosenbrock, ATableauWithAWrongCoefficientIsNotProven) {
  auto wrong = methods::rodas4_tableau;
  wrong.c[3][1] += 1e-6;
  EXPECT_GT(std::abs(order_fault(wrong, wrong.m, 4).residual), 1e-9);
  EXPECT_EQ(order_fault(methods::rodas4_tableau, methods::rodas4_tableau.m, 4).order, 0);
}

TEST(Rosenbrock, BothFormsOfATableauAgree) {
  // Through alpha, Gamma and b, and back.
  const auto& t = methods::rodas5p_tableau;
  const auto back = rosenbrock_from<8>(t.alpha_matrix(), t.gamma_matrix(), t.weights(t.m), 5,
                                       t.weights(t.m_hat), 4);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(back.m[i], t.m[i], 1e-9);
    EXPECT_NEAR(back.m_hat[i], t.m_hat[i], 1e-9);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_NEAR(back.a[i][j], t.a[i][j], 1e-9);
      EXPECT_NEAR(back.c[i][j], t.c[i][j], 1e-9 * (1 + std::abs(t.c[i][j])));
    }
  }
}

TEST(Rosenbrock, StabilityAtInfinity) {
  EXPECT_LE(methods::rosenbrock_euler::amplification(-1e12, 0), 1e-9);
  EXPECT_LE(methods::ros2::amplification(-1e12, 0), 1e-9);
  EXPECT_LE(methods::rodas4::amplification(-1e9, 0), 1e-6);
  EXPECT_LE(methods::rodas5p::amplification(-1e9, 0), 1e-6);
  // ROS3P is A-stable only: |R(inf)| = 0.73 (Lang, Verwer 2001).
  EXPECT_NEAR(methods::ros3p::amplification(-1e9, 0), 0.73, 0.005);
  for (double y = 1e-2; y < 1e6; y *= 1.2) {
    EXPECT_LE(methods::ros2::amplification(0, y), 1 + 1e-12) << y;
    EXPECT_LE(methods::ros3p::amplification(0, y), 1 + 1e-12) << y;
    EXPECT_LE(methods::rodas4::amplification(0, y), 1 + 1e-10) << y;
    EXPECT_LE(methods::rodas5p::amplification(0, y), 1 + 1e-10) << y;
  }
}

TEST(Seulex, HasTheOrderOfItsColumn) {
  const double p = methods::seulex::info.order;
  // No term of the expansion in h vanishes: the slope converges slowly.
  EXPECT_NEAR((measured_order<methods::seulex, DrivenDecay>(64)), p, 0.3);
  EXPECT_NEAR((measured_order<methods::seulex, LinearOscillator>(64)), p, 0.3);
  EXPECT_NEAR((measured_order<methods::seulex, AnalyticLogistic>(64, 10)), p, 0.3);
}

}  // namespace
}  // namespace odeum::tests::rosenbrock_test
