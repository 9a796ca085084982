// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "odeum/linear/conjugate_gradients.hpp"
#include "odeum/linear/dense_lu.hpp"
#include "odeum/linear/shifted_solver.hpp"

namespace odeum::tests::linear_test {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool factorise(linear::DenseLu& lu, const RowMajor& matrix) {
  std::copy(matrix.data(), matrix.data() + matrix.size(), lu.data());
  return lu.factorise();
}

TEST(DenseLu, SolvesRandomSystemsOfEverySize) {
  std::srand(1);
  for (const std::size_t n : {1U, 2U, 3U, 5U, 16U, 60U}) {
    const auto size = static_cast<Eigen::Index>(n);
    const RowMajor a = RowMajor::Random(size, size);
    const Eigen::VectorXd exact = Eigen::VectorXd::Random(size);
    Eigen::VectorXd x = a * exact;
    linear::DenseLu lu(n);
    ASSERT_TRUE(factorise(lu, a)) << n;
    lu.solve(x.data());
    // Partial pivoting is backward stable: the residual is some n roundings of |A| |x|.
    EXPECT_LE((a * x - a * exact).norm(),
              10 * static_cast<double>(n) * 2.3e-16 * a.norm() * x.norm());
  }
}

TEST(DenseLu, PivotsWhereTheDiagonalIsZeroOrTiny) {
  RowMajor a(3, 3);
  a << 0, 2, 1, 1e-20, 1, 3, 4, 0, 1;
  linear::DenseLu lu(3);
  ASSERT_TRUE(factorise(lu, a));
  Eigen::Vector3d x = a * Eigen::Vector3d(1, -2, 3);
  lu.solve(x.data());
  EXPECT_LE((x - Eigen::Vector3d(1, -2, 3)).norm(), 1e-14);  // a dozen operations, condition 5
}

TEST(DenseLu, RefusesSingularAndNonFiniteMatrices) {
  linear::DenseLu lu(2);
  RowMajor a(2, 2);
  a << 1, 2, 2, 4;
  EXPECT_FALSE(factorise(lu, a));
  a.setZero();
  EXPECT_FALSE(factorise(lu, a));
  // In each place, beside zeros that elimination skips.
  for (Eigen::Index i = 0; i < 2; ++i)
    for (Eigen::Index j = 0; j < 2; ++j)
      for (const double bad : {nan, inf, -inf}) {
        a.setIdentity();
        a(i, j) = bad;
        EXPECT_FALSE(factorise(lu, a)) << bad << " at " << i << ", " << j;
      }
  a.setIdentity();
  EXPECT_TRUE(factorise(lu, a)) << "a refusal leaves no trace";
}

struct Cg {
  explicit Cg(const Eigen::MatrixXd& matrix)
      : a(matrix), solver(static_cast<std::size_t>(matrix.rows())) {}
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance) {
    applications = 0;
    const auto n = a.rows();
    const auto apply = [&](const double* p, double* ap) {
      ++applications;
      Eigen::Map<Eigen::VectorXd>(ap, n) = a * Eigen::Map<const Eigen::VectorXd>(p, n);
    };
    const auto jacobi = [&](const double* r, double* z) {
      for (Eigen::Index i = 0; i < n; ++i) z[i] = r[i] / a(i, i);
    };
    return solver.solve(apply, jacobi, b.data(), x.data(), tolerance);
  }
  Eigen::MatrixXd a;
  linear::ConjugateGradients solver;
  int applications = 0;
};

TEST(ConjugateGradients, MeetsItsToleranceOnPositiveDefiniteSystems) {
  std::srand(2);
  for (const Eigen::Index n : {1, 4, 30}) {
    const Eigen::MatrixXd root = Eigen::MatrixXd::Random(n, n);
    Cg cg(root * root.transpose() + Eigen::MatrixXd::Identity(n, n));
    const Eigen::VectorXd b = Eigen::VectorXd::Random(n);
    Eigen::VectorXd x = Eigen::VectorXd::Random(n);
    ASSERT_TRUE(cg.solve(b, x, 1e-12));
    // The recurrence for the residual drifts from the residual by roundings, below 1e-13 here.
    EXPECT_LE((b - cg.a * x).norm(), 1.2e-12 * b.norm());
    EXPECT_LE(cg.applications, n + 10) << "n steps in exact arithmetic, and the first residual";
  }
}

TEST(ConjugateGradients, KeepsAnExactGuessAndSolvesForZero) {
  Cg cg(Eigen::MatrixXd::Identity(3, 3) * 2);
  Eigen::VectorXd x = Eigen::Vector3d(1, 2, 3);
  EXPECT_TRUE(cg.solve(2 * x, x, 1e-12));
  EXPECT_EQ(x, Eigen::VectorXd(Eigen::Vector3d(1, 2, 3)));
  EXPECT_EQ(cg.applications, 1);
  EXPECT_TRUE(cg.solve(Eigen::Vector3d::Zero(), x, 1e-12));
  EXPECT_LE(x.norm(), 1e-15);  // one exact step from the guess
}

TEST(ConjugateGradients, SaysWhenTheMatrixIsIndefiniteOrNotFinite) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(3, 3);
  a(0, 1) = a(1, 0) = 2;  // eigenvalues 3, -1, 1
  Eigen::VectorXd x = Eigen::Vector3d::Zero();
  EXPECT_FALSE(Cg(a).solve(Eigen::Vector3d(1, -1, 0), x, 1e-12));
  a = Eigen::MatrixXd::Identity(3, 3);
  a(2, 2) = nan;
  x.setZero();
  EXPECT_FALSE(Cg(a).solve(Eigen::Vector3d(1, -1, 1), x, 1e-12));
}

/// y0' = -2 y0 + y1^2, y1' = t y0 - 3 y1, with and without a Jacobian of its own.
template <bool WithJ>
struct Coupled {
  static constexpr std::size_t dimension = 2;
  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = -2 * y[0] + y[1] * y[1];
    dydt[1] = t * y[0] - 3 * y[1];
  }
  void jacobian(double t, const double* y, double* j) const requires WithJ {
    j[0] = -2;
    j[1] = 2 * y[1];
    j[2] = t;
    j[3] = -3;
  }
};

template <bool WithJ>
double shifted_residual() {
  const Coupled<WithJ> problem;
  const auto solver = make_shifted_solver(problem);
  const double y[] = {0.4, 1.3}, gamma_h = 0.7, t = 1.9;
  Eigen::Matrix2d j;
  j << -2, 2 * y[1], t, -3;
  const Eigen::Vector2d r(1, -2);
  Eigen::Vector2d x = r;
  EXPECT_TRUE(solver->factorise(t, y, gamma_h));
  EXPECT_TRUE(solver->solve(x.data(), ShiftedSolver::exact));
  return ((Eigen::Matrix2d::Identity() - gamma_h * j) * x - r).norm();
}

TEST(DenseShiftedSolver, SolvesWithTheJacobianOrItsDifferences) {
  EXPECT_LE(shifted_residual<true>(), 1e-15);  // a few roundings of size one
  // Forward differences err by sqrt(epsilon) |f''| / 2 = 1.5e-8 and by rounding of the same size.
  const double differenced = shifted_residual<false>();
  EXPECT_LE(differenced, 1e-7);
  EXPECT_GT(differenced, 0);
}

}  // namespace
}  // namespace odeum::tests::linear_test
