// SPDX-License-Identifier: BSD-3-Clause
// Formulas as lecture material prints them, run as printed beside the right ones: the measured
// effects of reports/findings/course.md.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "odeum/fem/elliptic.hpp"
#include "odeum/fem/second_order_pde.hpp"
#include "odeum/fem/shapes.hpp"
#include "odeum/linear/eigen_solvers.hpp"
#include "odeum/proof/verify.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::course_formulas_test {
namespace {

using State2 = std::array<double, 2>;

// The notebook's oscillator: m = 1, k = 5.
constexpr double stiffness = 5, mass = 1, rest = 2;

/// Implicit Euler on x'' = k/m (rest - x): (I - h A) u_new = u + h b, with the given lower left
/// entry of the matrix and second entry of b.
State2 implicit_euler(double lower_left, double b, double h, int steps, State2 u) {
  for (int i = 0; i < steps; ++i) {
    const State2 right{u[0], u[1] + h * b};
    const double determinant = 1 + h * lower_left;  // of [1, -h; lower_left, 1]
    u = {(right[0] + h * right[1]) / determinant, (right[1] - lower_left * right[0]) / determinant};
  }
  return u;
}

// The matrix of the step is [1, -h; +h k/m, 1]. With -h k/m its inverse has the eigenvalue
// 1 / (1 - h sqrt(k/m)): the solution grows as exp(sqrt(k/m) t), at every step.
TEST(CourseFormulas, TheImplicitMatrixWithTheOtherSignGrowsLikeAnExponential) {
  const double h = 1e-4;
  const int steps = 50'000;
  const State2 start{1, 0};
  const State2 right = implicit_euler(h * stiffness / mass, 0, h, steps, start);
  const State2 printed = implicit_euler(-h * stiffness / mass, 0, h, steps, start);
  EXPECT_NEAR(right[0], std::cos(std::sqrt(5) * 5), 2e-3) << "implicit Euler: of order 1";
  // cosh of 11.18, and the error of order 1: 11.18^2 h / (2 * 5) of the exponent.
  EXPECT_NEAR(printed[0] / std::cosh(std::sqrt(5) * 5), 1, 2e-3);
}

// b = (0, k rest / m). Without k / m the spring comes to rest where k/m x = rest.
TEST(CourseFormulas, WithoutTheStiffnessInBTheSpringRestsElsewhere) {
  const double h = 0.1, lower_left = h * stiffness / mass;
  EXPECT_NEAR(implicit_euler(lower_left, stiffness * rest / mass, h, 2000, {3, 0})[0], 2, 1e-10);
  EXPECT_NEAR(implicit_euler(lower_left, rest, h, 2000, {3, 0})[0], 2 / stiffness, 1e-10);
}

/// y' = -y + cos t + sin t, y = sin t.
double f(double t, double y) { return -y + std::cos(t) + std::sin(t); }

/// RK4 to t = 2 with the fourth stage evaluated at t + node h.
double rk4_error(double node, int steps) {
  const double h = 2. / steps;
  double y = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h, k1 = f(t, y), k2 = f(t + h / 2, y + h / 2 * k1),
                 k3 = f(t + h / 2, y + h / 2 * k2), k4 = f(t + node * h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return std::abs(y - std::sin(2.));
}

// On a problem that depends on the time, RK4 with 0 as its fourth node has order 1, with 1 order 4;
// a slope between two steps lies within a tenth of it.
TEST(CourseFormulas, TheFourthNodeOfRk4IsOne) {
  EXPECT_NEAR(std::log2(rk4_error(1, 100) / rk4_error(1, 200)), 4, 0.1);
  EXPECT_NEAR(std::log2(rk4_error(0, 100) / rk4_error(0, 200)), 1, 0.1);
  EXPECT_GT(rk4_error(0, 100) / rk4_error(1, 100), 1e5);
}

struct Doubling {
  std::uint64_t steps = 0;
  double t = 0, largest = 0;  ///< of the differences in steps that were kept
};

/// Step doubling of explicit Euler on y' = -y, y(0) = 1 to t = 1, with 1e-4 and 2e-5 as the upper
/// and the lower bound. As printed the step is halved where the difference is below the upper
/// bound.
Doubling step_doubling(bool printed, double h, std::uint64_t most) {
  Doubling run;
  double y = 1;
  while (run.t < 1 && run.steps < most) {
    h = std::min(h, 1 - run.t);
    const double whole = y - h * y, half = y - h / 2 * y, halves = half - h / 2 * half;
    const double e = std::abs(whole - halves);
    ++run.steps;
    if (!printed && e > 1e-4) {
      h /= 2;  // the step is repeated
      continue;
    }
    run.t += h;
    run.largest = std::max(run.largest, e);
    y = halves;
    if (printed && e < 1e-4)
      h /= 2;
    else if (e < 2e-5)
      h *= 2;
  }
  return run;
}

// The test halves the step where the two results differ by more than the upper bound. As printed it
// halves where they differ by less: from a step that is too long, all are kept as long as that;
// from one that is short enough, each is half of the one before, and the run comes to a stop.
TEST(CourseFormulas, StepDoublingAsPrintedKeepsLongStepsAndHalvesShortOnes) {
  constexpr std::uint64_t many = 1'000'000;
  for (const double first : {0.1, 0.01}) {
    const Doubling right = step_doubling(false, first, many);
    EXPECT_EQ(right.t, 1);
    EXPECT_LT(right.steps, 100U);
    EXPECT_LE(right.largest, 1e-4);
  }
  const Doubling from_long = step_doubling(true, 0.1, many);
  EXPECT_NEAR(from_long.largest, 2.5e-3, 1e-12) << "h^2 / 4: 25 times the bound";
  const Doubling from_short = step_doubling(true, 0.01, many);
  EXPECT_EQ(from_short.steps, many);
  EXPECT_NEAR(from_short.t, 0.02, 1e-12) << "the sum of 0.01 / 2^k";
}

// The order that remains where the third coefficient of the last row has the other sign.
TEST(CourseFormulas, ASignInCashAndKarpsTableLeavesOrderOne) {
  const TableauFile file =
      read_tableau_file(ODEUM_SOURCE_DIR "/cases/tableaus/cash_karp54_misprint.yaml");
  const proof::Verification verification = proof::verify(file);
  EXPECT_FALSE(verification.passed());
  EXPECT_EQ(verification.main.order, 1);
  ASSERT_EQ(verification.nodes.size(), 1U);
  EXPECT_EQ(verification.nodes[0].stage, 6U);
}

// The summary's equation 34 has no term in u_yy, and its c before u_x: the c of the discriminant
// b^2 - 4 a c is that of u_yy. As printed no equation is elliptic, Laplace's neither.
TEST(CourseFormulas, WithoutATermInUyyNoEquationIsElliptic) {
  const auto type = [](const char* text) { return fem::SecondOrderPde(text).at(0.3, 0.4).type; };
  EXPECT_EQ(type("u_xx + u_yy"), fem::PdeType::elliptic);
  EXPECT_EQ(type("u_xx + 1*u_x + u_y"), fem::PdeType::parabolic) << "a = c = 1, b = 0 as printed";
  EXPECT_EQ(type("u_xx + u_xy + 1*u_x + u_y"), fem::PdeType::hyperbolic) << "b = 1 as printed";
  EXPECT_EQ(type("u_xx + u_xy + u_yy"), fem::PdeType::elliptic);
}

// The summary's equation 41, the integral of grad u grad v = that of f v, belongs to -div grad u =
// f; its equation 38 is div grad u = f. On u = x (1 - x) y (1 - y) the solution as printed is -u.
TEST(CourseFormulas, TheWeakFormAsPrintedSolvesForTheNegativeSolution) {
  const auto u = [](fem::Point p) { return p.x * (1 - p.x) * p.y * (1 - p.y); };
  const auto laplacian = [](fem::Point p) { return -2 * (p.x * (1 - p.x) + p.y * (1 - p.y)); };
  const fem::TriangleMesh mesh = fem::unstructured_square(20, 3);
  // Our weak form has the left side as printed; `sign` is that of its right side.
  for (const double sign : {1., -1.}) {
    const fem::EllipticSystem system = fem::assemble(
        mesh, {.load = [&](fem::Point p) { return sign * laplacian(p); }}, fem::degree_5_rule());
    std::vector<double> x(system.right.size());
    linear::SparseLdlt(system.matrix).solve(system.right.data(), x.data());
    const std::vector<double> nodal = system.nodal(x);
    double error = 0;
    for (std::size_t i = 0; i < nodal.size(); ++i)
      error = std::max(error, std::abs(nodal[i] + sign * u(mesh.nodes[i])));
    EXPECT_LT(error, 1e-3) << "of u up to 1/16, to the order 2 of linear elements";
  }
}

}  // namespace
}  // namespace odeum::tests::course_formulas_test
