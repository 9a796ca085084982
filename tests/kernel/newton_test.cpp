// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/kernel/newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "odeum/methods/esdirk43.hpp"
#include "odeum/methods/implicit_euler.hpp"
#include "odeum/methods/implicit_euler_fixed_point.hpp"
#include "odeum/methods/sdirk2.hpp"
#include "odeum/methods/sdirk4.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::newton_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// y' = sign * y^2, with a count of evaluations.
struct Square {
  static constexpr std::size_t dimension = 1;
  double sign = 1;
  mutable int evaluations = 0, jacobians = 0;
  void rhs(double, const double* y, double* dydt) const {
    ++evaluations;
    dydt[0] = sign * y[0] * y[0];
  }
  void jacobian(double, const double* y, double* j) const {
    ++jacobians;
    j[0] = 2 * sign * y[0];
  }
};

/// Robertson's reactions.
struct Robertson {
  static constexpr std::size_t dimension = 3;
  void rhs(double, const double* y, double* f) const {
    f[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
    f[2] = 3e7 * y[1] * y[1];
    f[1] = -f[0] - f[2];
  }
  void jacobian(double, const double* y, double* j) const {
    const double first[] = {-0.04, 1e4 * y[2], 1e4 * y[1]}, third[] = {0, 6e7 * y[1], 0};
    for (int k = 0; k < 3; ++k) {
      j[k] = first[k];
      j[3 + k] = -first[k] - third[k];
      j[6 + k] = third[k];
    }
  }
};

TEST(Newton, SolvesAQuadraticEquationToRounding) {
  const Square problem;
  Newton<Square> newton(problem);
  const std::array<double, 1> base{0.3};
  std::array<double, 1> y = base;
  ASSERT_EQ(newton.solve(0, 0.5, base, y), Status::ok);
  // y = b + y^2 / 2 has the roots 1 -+ sqrt(1 - 2b). The last correction is below 1e-13 |y|, and a
  // kept Jacobian contracts by 0.1 or better: the remaining error is at most 0.1 / 0.9 of it.
  EXPECT_NEAR(y[0], 1 - std::sqrt(1 - 2 * 0.3), 5e-15);
  EXPECT_LE(problem.evaluations, 16) << "13 digits, one a correction or more";
  EXPECT_GE(problem.jacobians, 1);
}

struct Linear {
  static constexpr std::size_t dimension = 1;
  mutable int evaluations = 0;
  void rhs(double, const double* y, double* dydt) const {
    ++evaluations;
    dydt[0] = -4 * y[0];
  }
  void jacobian(double, const double*, double* j) const { j[0] = -4; }
};

TEST(Newton, SolvesALinearEquationInOneCorrection) {
  const Linear problem;
  Newton<Linear> newton(problem);
  std::array<double, 1> y{1};
  ASSERT_EQ(newton.solve(0, 0.25, {1}, y), Status::ok);
  EXPECT_EQ(y[0], 0.5);
  EXPECT_EQ(problem.evaluations, 2) << "one to solve, one to see that it is solved";
}

TEST(Newton, ReportsWhereThereIsNoSolution) {
  const Square problem;
  Newton<Square> newton(problem);
  const std::array<double, 1> base{3};  // y = 3 + y^2 has no real root
  std::array<double, 1> y = base;
  EXPECT_EQ(newton.solve(0, 1, base, y), Status::newton_failed);
  EXPECT_LE(problem.evaluations, 50);
}

TEST(Newton, ReportsASingularMatrix) {
  const Square problem;
  Newton<Square> newton(problem);
  std::array<double, 1> y{0.5};  // 1 - gamma_h 2 y = 0 at the guess
  EXPECT_EQ(newton.solve(0, 1, {0.5}, y), Status::newton_failed);
}

/// y' = -atan(k y): full corrections from afar lead further away.
struct Saturating {
  static constexpr std::size_t dimension = 1;
  static constexpr double k = 1e4;
  mutable int evaluations = 0;
  void rhs(double, const double* y, double* f) const {
    ++evaluations;
    f[0] = -std::atan(k * y[0]);
  }
  void jacobian(double, const double* y, double* j) const { j[0] = -k / (1 + k * k * y[0] * y[0]); }
};

TEST(Newton, TakesLessOfACorrectionThatLeadsAway) {
  for (const double start : {1.0, 1.5, -2.0}) {
    const Saturating problem;
    Newton<Saturating> newton(problem);
    const std::array<double, 1> base{start};
    std::array<double, 1> y = base;
    ASSERT_EQ(newton.solve(0, 1, base, y), Status::ok) << start;
    EXPECT_NEAR(y[0] + std::atan(problem.k * y[0]), start, 1e-12 * (1 + std::abs(start))) << start;
    EXPECT_NEAR(newton.increment()[0], y[0] - base[0], 1e-12 * (1 + std::abs(start))) << start;
    EXPECT_LE(problem.evaluations, 50) << start;
  }
}

// In the first step from (1, 0, 0) the quadratic reaction overtakes a correction by the Jacobian at
// the start a thousand times. Without halving Newton diverged at every one of these steps.
TEST(Newton, SolvesRobertsonsFirstStepWithoutStepControl) {
  Robertson problem;
  for (const double h : {0.01, 0.1, 1.0, 10.0}) {
    methods::implicit_euler::Stepper<Robertson> stepper(problem);
    std::array<double, 3> y{1, 0, 0};
    ASSERT_EQ(stepper.step(0, h, y), Status::ok) << h;
    EXPECT_GT(y[1], 0) << h;
    EXPECT_NEAR(y[0] + y[1] + y[2], 1, 1e-14) << h;
    std::array<double, 3> f{};
    problem.rhs(0, y.data(), f.data());
    EXPECT_NEAR(y[0], 1 + h * f[0], 1e-12) << h;
  }
}

// A guess by the slope of the previous stage lay beyond zero, where Newton's method finds the other
// root of the quadratic reaction: y[1] was negative after these steps.
template <class Method>
void expect_the_positive_root(double h) {
  const Robertson problem;
  typename Method::template Stepper<Robertson> stepper(problem);
  std::array<double, 3> y{1, 0, 0};
  for (int step = 0; step < 20; ++step) {
    ASSERT_EQ(stepper.step(h * step, h, y), Status::ok) << Method::info.id << ' ' << h;
    // Quasi-steady: 3e7 y1^2 = 0.04 y0 within a factor of 4, while y2 is small.
    EXPECT_GT(y[1], 0.4e-5) << Method::info.id << ' ' << h << " step " << step;
    EXPECT_LT(y[1], 8e-5) << Method::info.id << ' ' << h << " step " << step;
  }
}
TEST(Newton, StagesFollowTheSolutionNotTheOtherRoot) {
  for (const double h : {0.02, 0.04, 0.1, 1.0, 10.0}) {
    expect_the_positive_root<methods::sdirk2>(h);
    expect_the_positive_root<methods::sdirk4>(h);
    expect_the_positive_root<methods::esdirk43>(h);
  }
}

TEST(Newton, MaxNormShowsANaNWhereverItStands) {
  EXPECT_EQ(max_norm(std::array{1.0, -3.0, 2.0}), 3);
  EXPECT_EQ(max_norm(std::array<double, 0>{}), 0);
  EXPECT_TRUE(std::isnan(max_norm(std::array{nan, 1.0})));
  EXPECT_TRUE(std::isnan(max_norm(std::array{1.0, nan, 2.0})));
  EXPECT_TRUE(std::isnan(max_norm(std::array{1.0, nan})));
}

/// The first component is NaN, the second converges at once.
struct HalfBad {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double*, double* dydt) const {
    dydt[0] = nan;
    dydt[1] = 0;
  }
  void jacobian(double, const double*, double* j) const {
    for (int i = 0; i < 4; ++i) j[i] = 0;
  }
};

TEST(Newton, IsNotSatisfiedByTheComponentsThatConverge) {
  const HalfBad problem;
  for (const double guess : {0.0, 1.0}) {
    std::array<double, 2> y{guess, guess};
    EXPECT_EQ(Newton<HalfBad>(problem).solve(0, 0.1, y, y), Status::newton_failed);
    std::array<double, 2> z{guess, guess};
    methods::implicit_euler_fixed_point::Stepper<HalfBad> fixed_point(problem);
    EXPECT_EQ(fixed_point.step(0, 0.1, z), Status::newton_failed);
  }
}

struct Decay {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = -y[0]; }
};

TEST(FixedPoint, ContractsBelowTheLipschitzBoundAndFailsAboveIt) {
  const Decay problem;
  methods::implicit_euler_fixed_point::Stepper<Decay> stepper(problem);
  std::array<double, 1> y{1};
  ASSERT_EQ(stepper.step(0, 0.5, y), Status::ok);
  // The last change is below 1e-11; with the contraction 1/2 the remaining error is at most that.
  EXPECT_NEAR(y[0], 1 / 1.5, 1e-11);
  const std::array<double, 1> before = y;
  EXPECT_EQ(stepper.step(0, 1.5, y), Status::newton_failed);
  EXPECT_EQ(y, before) << "a failed step leaves the state";
}

// The order over four decades of tolerance, from errors at the case's end and mean steps.
double order_to_a_tolerance(const char* id, const char* solver, double coarsest) {
  const Case& c = find_case(id);
  const double end = c.stops.back();
  std::vector<double> exact(c.y0.size());
  EXPECT_TRUE(c.truth.at(end, exact.data()));
  const auto run = [&](double tolerance, double& error) {
    const Outcome outcome = find_entrant(c, solver).solve(adaptive_request(tolerance, {end}));
    for (std::size_t i = 0; i < exact.size(); ++i)
      error = std::max(error, std::abs(outcome.states.at(i) - exact[i]));
    return static_cast<double>(outcome.counters.steps);
  };
  double coarse = 0, fine = 0;
  const double few = run(coarsest, coarse), many = run(1e-4 * coarsest, fine);
  return std::log(coarse / fine) / std::log(many / few);
}

// What Newton's iteration leaves falls faster than the tolerance, as a step's own error or faster:
// otherwise it is h^4 a step of sdirk4, whose order was 3.0, and those of Radau IIA were 4.5 here.
// Single tolerances scatter by 0.1.
TEST(Newton, LeavesTheOrderToATolerance) {
  EXPECT_NEAR(order_to_a_tolerance("vdp_mu1", "odeum/sdirk4", 1e-6), 4, 0.3);
  EXPECT_NEAR(order_to_a_tolerance("henon_heiles_regular", "odeum/radau_iia5", 1e-7), 5, 0.3);
}

}  // namespace
}  // namespace odeum::tests::newton_test
