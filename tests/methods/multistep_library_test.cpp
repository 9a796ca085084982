// SPDX-License-Identifier: BSD-3-Clause
// Linear multistep methods at a fixed step: measured orders, coefficients against the textbook.
#include <gtest/gtest.h>

#include "odeum/methods/adams_bashforth1.hpp"
#include "odeum/methods/adams_bashforth2.hpp"
#include "odeum/methods/adams_bashforth3.hpp"
#include "odeum/methods/adams_bashforth4.hpp"
#include "odeum/methods/adams_bashforth5.hpp"
#include "odeum/methods/adams_bashforth_moulton2.hpp"
#include "odeum/methods/adams_bashforth_moulton3.hpp"
#include "odeum/methods/adams_bashforth_moulton4.hpp"
#include "odeum/methods/adams_bashforth_moulton5.hpp"
#include "odeum/methods/bdf1.hpp"
#include "odeum/methods/bdf2.hpp"
#include "odeum/methods/bdf3.hpp"
#include "odeum/methods/bdf4.hpp"
#include "odeum/methods/bdf5.hpp"
#include "odeum/methods/bdf6.hpp"
#include "odeum/methods/bdf_variable.hpp"
#include "support/implicit_stage.hpp"

namespace odeum::tests::multistep_library_test {
namespace {

template <class M>
class Multistep : public testing::Test {};
using Methods = testing::Types<methods::adams_bashforth1, methods::adams_bashforth2,
                               methods::adams_bashforth3, methods::adams_bashforth4,
                               methods::adams_bashforth5, methods::adams_bashforth_moulton2,
                               methods::adams_bashforth_moulton3, methods::adams_bashforth_moulton4,
                               methods::adams_bashforth_moulton5, methods::bdf1, methods::bdf2,
                               methods::bdf3, methods::bdf4, methods::bdf5, methods::bdf6>;
TYPED_TEST_SUITE(Multistep, Methods);

TYPED_TEST(Multistep, HasItsOrder) {
  const double p = TypeParam::info.order;
  // The next term of the expansion moves one halving's slope by less than a quarter of an order.
  const std::uint64_t steps = p >= 6 ? 60 : 160;
  EXPECT_NEAR((measured_order<TypeParam, LinearOscillator>(steps)), p, 0.25);
  EXPECT_NEAR((measured_order<TypeParam, DrivenDecay>(steps)), p, 0.25);
  EXPECT_NEAR((measured_order<TypeParam, Logistic>(p >= 5 ? 30 : steps)), p, 0.25);
}

TEST(MultistepCoefficients, AreThoseOfTheTextbook) {
  // Solving ODEs I, (III.1.5), (III.1.9) and (III.1.22').
  const auto ab4 = adams_bashforth_coefficients<4>();
  const double ab4_beta[] = {0, 55. / 24, -59. / 24, 37. / 24, -9. / 24};
  const auto am4 = adams_moulton_coefficients<3>();
  const double am4_beta[] = {9. / 24, 19. / 24, -5. / 24, 1. / 24};
  const auto bdf3 = backward_difference_coefficients<3>();
  const double bdf3_alpha[] = {11. / 6, -3, 3. / 2, -1. / 3};
  // A few roundings of numbers of size one.
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(ab4.beta[i], ab4_beta[i], 1e-15);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(am4.beta[i], am4_beta[i], 1e-15);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(bdf3.alpha[i], bdf3_alpha[i], 1e-15);
}

TEST(MultistepCoefficients, AWrongOneIsNotProven) {
  static constexpr auto wrong = [] {
    auto c = backward_difference_coefficients<4>();
    c.alpha[2] += 1e-9;
    return c;
  }();
  constexpr MultistepFault fault = multistep_fault(wrong, 4);
  EXPECT_EQ(fault.degree, 0) << "the sum of the alphas";
  EXPECT_NEAR(fault.residual, 1e-9 / 4, 1e-14) << "over the largest of them, 4";
  constexpr auto bdf4 = backward_difference_coefficients<4>();
  EXPECT_EQ(multistep_fault(bdf4, 4).degree, -1);
  EXPECT_EQ(multistep_fault(bdf4, 3).degree, 4) << "no less either";
  EXPECT_EQ(multistep_fault(bdf4, 3).residual, 0);
}

TEST(BdfVariable, FollowsItsToleranceThroughEveryStop) {
  const LinearOscillator problem;
  double before = 1;
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    Request request{.mode = Mode::adaptive, .tolerance = tolerance, .stops = {0.1, 0.5, 2, 5}};
    const Outcome outcome =
        run<methods::bdf_variable>(problem, 0, LinearOscillator::exact(0), request);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    double worst = 0;
    for (std::size_t s = 0; s < 4; ++s) {
      const auto exact = LinearOscillator::exact(request.stops[s]);
      for (std::size_t i = 0; i < 2; ++i)
        worst = std::max(worst, std::abs(outcome.states[2 * s + i] - exact[i]));
    }
    // Two decades of tolerance: one of error at the least; local errors add up over the run.
    EXPECT_LE(worst, 200 * tolerance) << tolerance;
    EXPECT_LE(worst, before / 10);
    before = worst;
  }
}

TEST(BdfVariable, ReachesTheHighestOrders) {
  // At order 5 a decade of tolerance costs a factor 10^(1/6) in steps; at order 2 it were 2.2.
  const auto steps = [](double tolerance) {
    return static_cast<double>(run_to_tolerance<methods::bdf_variable>(
                                   LinearOscillator{}, LinearOscillator::exact(0), 20, tolerance)
                                   .counters.steps);
  };
  EXPECT_LE(steps(1e-9) / steps(1e-7), 2.6) << "10^(2/6) = 2.15 at order 5, 2.5 at order 4";
}

}  // namespace
}  // namespace odeum::tests::multistep_library_test
