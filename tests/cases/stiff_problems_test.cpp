// SPDX-License-Identifier: BSD-3-Clause
// Adaptive stiff methods on three classical stiff problems, and on problems without a solution.
#include <gtest/gtest.h>

#include "odeum/methods/bdf_variable.hpp"
#include "odeum/methods/esdirk43.hpp"
#include "odeum/methods/radau_iia5.hpp"
#include "odeum/methods/radau_iia9.hpp"
#include "odeum/methods/rodas4.hpp"
#include "odeum/methods/rodas5p.hpp"
#include "odeum/methods/seulex.hpp"
#include "support/implicit_stage.hpp"

namespace odeum::tests::stiff_problems_test {
namespace {

// The values at the end: reference solution to 25 digits.
constexpr State<Hires> hires_end{
    6.703055035818636e-4, 1.3099684698634689e-4, 4.6862231597731583e-5, 1.0446680205517048e-3,
    5.948838309514851e-4, 1.3996288339427741e-3, 1.0144927577184797e-3, 4.6855072422815203e-3};
constexpr State<Robertson> robertson_end{5.208353144253499e-9, 2.0833412684220113e-14,
                                         0.999999994791626};
constexpr State<VanDerPol> van_der_pol_end{-1.5106069367441115, 1.178380000730911e-3};

template <class M>
class StiffProblems : public testing::Test {};
using StiffMethods = testing::Types<methods::rodas4, methods::rodas5p, methods::radau_iia5,
                                    methods::radau_iia9, methods::seulex, methods::bdf_variable>;
TYPED_TEST_SUITE(StiffProblems, StiffMethods);

constexpr double tolerances[] = {1e-4, 1e-7, 1e-10};

// The local error is held to the tolerance; along a stable solution the global one stays within
// some tens of it.
TYPED_TEST(StiffProblems, Hires) {
  for (const double tolerance : tolerances)
    EXPECT_LE(end_error(run_to_tolerance<TypeParam>(Hires{}, Hires::start(), 421.8122, tolerance),
                        hires_end),
              100 * tolerance)
        << tolerance;
}

TYPED_TEST(StiffProblems, RobertsonToTheEndOfTime) {
  for (const double tolerance : tolerances)
    EXPECT_LE(
        end_error(run_to_tolerance<TypeParam>(Robertson{}, Robertson::start(), 4e11, tolerance),
                  robertson_end),
        100 * tolerance)
        << tolerance;
}

// Phase errors of each jump accumulate.
TYPED_TEST(StiffProblems, VanDerPol) {
  for (const double tolerance : tolerances)
    EXPECT_LE(
        end_error(run_to_tolerance<TypeParam>(VanDerPol{}, VanDerPol::start(), 3000, tolerance),
                  van_der_pol_end),
        100 * tolerance)
        << tolerance;
}

/// y' = y^2 from 1: a pole at t = 1.
struct Pole {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = y[0] * y[0]; }
  void jacobian(double, const double* y, double* j) const { j[0] = 2 * y[0]; }
};

TYPED_TEST(StiffProblems, PastAPoleIsNoSuccess) {
  const Outcome outcome = run_to_tolerance<TypeParam>(Pole{}, {1}, 2, 1e-6);
  EXPECT_NE(outcome.status, Status::ok);
  EXPECT_NEAR(outcome.t, 1, 0.01) << to_string(outcome.status) << ' ' << outcome.detail;
}

/// Not a number from t = 0.5 on.
struct Broken {
  static constexpr std::size_t dimension = 2;
  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = t < 0.5 ? -y[0] : std::nan("");
    dydt[1] = -y[1];
  }
};

TYPED_TEST(StiffProblems, NotANumberIsSaidToBeOne) {
  const Outcome outcome = run_to_tolerance<TypeParam>(Broken{}, {1, 1}, 2, 1e-6);
  EXPECT_EQ(outcome.status, Status::step_too_small) << outcome.detail;
  EXPECT_NE(outcome.detail.find("component 0 is nan at t = "), std::string::npos) << outcome.detail;
}

/// y' = -1e8 (y - cos t) - sin t from its smooth solution cos t.
struct ProtheroRobinson {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = -1e8 * (y[0] - std::cos(t)) - std::sin(t);
  }
  void jacobian(double, const double*, double* j) const { j[0] = -1e8; }
  void time_derivative(double t, const double*, double* dfdt) const {
    dfdt[0] = -1e8 * std::sin(t) - std::cos(t);
  }
};

TYPED_TEST(StiffProblems, ExtremeStiffnessCostsNoSteps) {
  const Outcome outcome = run_to_tolerance<TypeParam>(ProtheroRobinson{}, {1}, 10, 1e-6);
  EXPECT_LE(end_error(outcome, State<ProtheroRobinson>{std::cos(10.0)}), 1e-4);
  // An explicit method would need 5e8.
  EXPECT_LE(outcome.counters.steps, 20000U);
}

TEST(StiffJacobians, AreKeptWhileNewtonConvergesFast) {
  const auto jacobians_a_step = [](const Outcome& outcome) {
    return static_cast<double>(outcome.counters.jacobian_evaluations) /
           static_cast<double>(outcome.counters.steps);
  };
  const auto run_on = [&]<class M>(M) {
    return run_to_tolerance<M>(VanDerPol{}, VanDerPol::start(), 3000, 1e-7);
  };
  // A linearly implicit method needs one per accepted step, for any number of rejections.
  EXPECT_EQ(jacobians_a_step(run_on(methods::rodas4{})), 1);
  EXPECT_LT(jacobians_a_step(run_on(methods::bdf_variable{})), 0.25);
  EXPECT_LT(jacobians_a_step(run_on(methods::radau_iia5{})), 1);
  EXPECT_LT(jacobians_a_step(run_on(methods::esdirk43{})), 1);
}

}  // namespace
}  // namespace odeum::tests::stiff_problems_test
