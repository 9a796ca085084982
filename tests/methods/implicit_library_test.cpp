// SPDX-License-Identifier: BSD-3-Clause
// Diagonally and fully implicit Runge-Kutta methods: measured orders, stability properties.
#include <gtest/gtest.h>

#include <complex>

#include "odeum/methods/esdirk43.hpp"
#include "odeum/methods/gauss4.hpp"
#include "odeum/methods/gauss6.hpp"
#include "odeum/methods/implicit_euler.hpp"
#include "odeum/methods/implicit_midpoint.hpp"
#include "odeum/methods/lobatto_iiic4.hpp"
#include "odeum/methods/radau_iia3.hpp"
#include "odeum/methods/radau_iia5.hpp"
#include "odeum/methods/radau_iia9.hpp"
#include "odeum/methods/sdirk2.hpp"
#include "odeum/methods/sdirk3.hpp"
#include "odeum/methods/sdirk4.hpp"
#include "odeum/methods/tr_bdf2.hpp"
#include "odeum/methods/trapezoidal.hpp"
#include "support/implicit_stage.hpp"

namespace odeum::tests::implicit_library_test {
namespace {

template <class M>
class Implicit : public testing::Test {
 public:
  /// Fine enough for the slope to settle, coarse enough to stay clear of rounding.
  static constexpr std::uint64_t steps = M::info.order >= 9 ? 5 : M::info.order >= 5 ? 10 : 80;
};
using Methods =
    testing::Types<methods::implicit_euler, methods::implicit_midpoint, methods::trapezoidal,
                   methods::sdirk2, methods::sdirk3, methods::tr_bdf2, methods::sdirk4,
                   methods::esdirk43, methods::gauss4, methods::gauss6, methods::radau_iia3,
                   methods::radau_iia5, methods::radau_iia9, methods::lobatto_iiic4>;
TYPED_TEST_SUITE(Implicit, Methods);

// One halving at a finite step: the next term of the error's expansion moves the slope by less than
// a quarter of an order; at order 9 the few steps that rounding leaves move it by half an order.
TYPED_TEST(Implicit, HasItsOrder) {
  const double p = TypeParam::info.order, band = p >= 9 ? 0.5 : 0.25;
  EXPECT_NEAR((measured_order<TypeParam, LinearOscillator>(TestFixture::steps)), p, band);
  EXPECT_NEAR((measured_order<TypeParam, DrivenDecay>(TestFixture::steps)), p, band);
  EXPECT_NEAR((measured_order<TypeParam, Logistic>(p >= 9 ? 4 : p >= 4 ? 20 : 80, 10)), p, band);
}

// What is compiled for a type whose dimension is known, as timed runs have it, takes the same steps
// as what is compiled for any: matrices are inverted in another order, some roundings a step.
TYPED_TEST(Implicit, StepsAlikeWhereTheDimensionIsKnown) {
  const LinearOscillator problem;
  const State<LinearOscillator> y0 = LinearOscillator::exact(0);
  const Outcome any = run_fixed_steps<TypeParam>(problem, y0, 1.5, 10);
  typename TypeParam::template Stepper<LinearOscillator> stepper(problem);
  State<LinearOscillator> y = y0;
  for (int i = 0; i < 10; ++i) ASSERT_EQ(stepper.step(0.15 * i, 0.15, y), Status::ok);
  // Newton ends at 1e-13 of the state, ten times.
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], any.states[i], 1e-11);
}

// The running code on y' = z y, z anywhere, against the stability function.
struct Dahlquist {
  static constexpr std::size_t dimension = 2;
  std::complex<double> z;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = z.real() * y[0] - z.imag() * y[1];
    dydt[1] = z.imag() * y[0] + z.real() * y[1];
  }
  void jacobian(double, const double*, double* j) const {
    j[0] = j[3] = z.real();
    j[1] = -z.imag();
    j[2] = z.imag();
  }
};

TYPED_TEST(Implicit, RunsAsItsStabilityFunctionSays) {
  for (const std::complex<double> z :
       {std::complex<double>(-0.3, 2), {-5, 1}, {-100, 40}, {1, 3}}) {
    const Outcome outcome = run_fixed_steps<TypeParam>(Dahlquist{z}, {1, 0}, 1, 1);
    ASSERT_EQ(outcome.status, Status::ok) << z;
    // Newton ends at 1e-13 of the state; some multiples of it with cancelling weights.
    EXPECT_NEAR(std::hypot(outcome.states[0], outcome.states[1]),
                TypeParam::amplification(z.real(), z.imag()), 1e-11)
        << z;
  }
}

TYPED_TEST(Implicit, IsAStable) {
  // |R| <= 1 on the imaginary axis and R analytic to the left of it (the diagonal or the
  // eigenvalues of A have positive real parts): by the maximum principle |R| <= 1 there.
  for (double y = 1e-3; y < 1e6; y *= 1.1)
    EXPECT_LE(TypeParam::amplification(0, y), 1 + 1e-12) << y;
}

TYPED_TEST(Implicit, IsLStableWhereItsDocumentationSaysSo) {
  // R is 1 - O(1/z) or O(1/z), and rounding of z eps.
  const double far = TypeParam::amplification(-1e8, 0);
  const std::string_view id = TypeParam::info.id;
  if (id == "implicit_midpoint" || id == "trapezoidal" || id == "gauss4" || id == "gauss6")
    EXPECT_NEAR(far, 1, 1e-6);
  else
    EXPECT_LE(far, 1e-6);
}

TYPED_TEST(Implicit, KeepsItsJacobianFromStepToStep) {
  const AnalyticLogistic problem;
  ASSERT_EQ(run_fixed_steps<TypeParam>(problem, Logistic::exact(0), 1.5, 200).status, Status::ok);
  // At this step the contraction with an old Jacobian is h times the change of J: a handful in all.
  EXPECT_GE(problem.jacobians, 1);
  EXPECT_LE(problem.jacobians, 10);
}

/// No real solution of the stage equations at h = 1: y' = 1 + y^2 from 1 has its pole at pi/4.
struct Tangent {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = 1 + y[0] * y[0]; }
};

TEST(ImplicitFailure, IsAStatus) {
  for (const Outcome& outcome : {run_fixed_steps<methods::implicit_euler>(Tangent{}, {1}, 1, 1),
                                 run_fixed_steps<methods::sdirk4>(Tangent{}, {1}, 4, 1),
                                 run_fixed_steps<methods::trapezoidal>(Tangent{}, {1}, 4, 1)})
    EXPECT_EQ(outcome.status, Status::newton_failed) << outcome.states.size();
}

TEST(Radau, EstimatesWithTheWeightsOfTheTextbook) {
  // Solving ODEs II, (IV.8.20): e = gamma0 / 3 (-13 - 7 sqrt 6, -13 + 7 sqrt 6, -1).
  const StageTransform& transform = stage_transform<methods::radau_iia5_tableau>();
  const double gamma0 = transform.inverse_mu[0].real();
  EXPECT_NEAR(1 / gamma0, 3.637834252744496, 1e-14);
  EXPECT_NEAR(transform.estimate[0] * 3 / gamma0, -13 - 7 * std::sqrt(6.0), 1e-12);
  EXPECT_NEAR(transform.estimate[1] * 3 / gamma0, -13 + 7 * std::sqrt(6.0), 1e-12);
  EXPECT_NEAR(transform.estimate[2] * 3 / gamma0, -1, 1e-12);
}

}  // namespace
}  // namespace odeum::tests::implicit_library_test
