// SPDX-License-Identifier: BSD-3-Clause
// Dense matrices whose size is known at run time.
#include "odeum/linear/dense_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace odeum::linear::dense_system_test {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Random {
  std::mt19937 engine{11};
  double operator()() { return std::uniform_real_distribution<double>(-1, 1)(engine); }
};

/// The identity and so many entries in a thousand.
Matrix random_matrix(Eigen::Index n, int in_a_thousand, Random& random) {
  Matrix m = Matrix::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      if (500 * (random() + 1) < in_a_thousand) m(i, j) += random();
  return m;
}

void expect_solved(DenseSystem& system, const Matrix& m) {
  std::copy(m.data(), m.data() + m.size(), system.data());
  ASSERT_TRUE(system.factorise());
  Eigen::VectorXd right(m.rows());
  for (Eigen::Index i = 0; i < m.rows(); ++i) right[i] = 1.0 / static_cast<double>(i + 1);
  Eigen::VectorXd x = right;
  system.solve(x.data());
  // Multipliers up to 100 may lose two digits each; seldom more than one does.
  EXPECT_LT((m * x - right).norm(), 1e-9 * (m.norm() * x.norm() + right.norm()));
  EXPECT_EQ(system.negative_determinant(), m.determinant() < 0);
}

void expect_solved(ComplexSystem& system, const Matrix& m) {
  const std::complex<double> g(0.7, -0.4);
  const Eigen::MatrixXcd whole = Eigen::MatrixXcd::Identity(m.rows(), m.rows()) - g * m;
  ASSERT_TRUE(system.factorise(g, m.data()));
  Eigen::VectorXd re(m.rows()), im(m.rows());
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    re[i] = 1.0 / static_cast<double>(i + 1), im[i] = 0.1 * static_cast<double>(i);
  const std::complex<double> unit(0, 1);
  const Eigen::VectorXcd right = re + unit * im;
  system.solve(re.data(), im.data());
  const Eigen::VectorXcd x = re + unit * im;
  EXPECT_LT((whole * x - right).norm(), 1e-9 * (whole.norm() * x.norm() + right.norm()));
}

// One system takes matrices of several patterns, as Jacobians along a solution are.
TEST(DenseSystem, SolvesMatricesOfAnySizeAndPattern) {
  Random random;
  for (const int n : {1, 2, 3, 5, 8, 16, 17, 20, 40, 128, 130}) {
    SCOPED_TRACE(n);
    DenseSystem system(static_cast<std::size_t>(n));
    ComplexSystem complex(static_cast<std::size_t>(n));
    for (const int many : {0, 20, 100, 100, 400, 1000, 50}) {
      const Matrix m = random_matrix(n, many, random);
      expect_solved(system, m);
      expect_solved(complex, m);
    }
  }
}

TEST(DenseSystem, ExchangesRows) {
  for (const Eigen::Index n : {2, 9, 30}) {
    SCOPED_TRACE(n);
    Matrix turned = Matrix::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) turned(i, (i + 1) % n) = 1 + 0.1 * static_cast<double>(i);
    DenseSystem system(static_cast<std::size_t>(n));
    expect_solved(system, turned);
  }
}

TEST(DenseSystem, RefusesSingularAndNonFiniteMatrices) {
  for (const Eigen::Index n : {3, 25}) {
    SCOPED_TRACE(n);
    DenseSystem system(static_cast<std::size_t>(n));
    Matrix m = Matrix::Identity(n, n);
    m.row(1) = m.row(2);
    std::copy(m.data(), m.data() + m.size(), system.data());
    EXPECT_FALSE(system.factorise());
    m(1, 1) = std::nan("");
    std::copy(m.data(), m.data() + m.size(), system.data());
    EXPECT_FALSE(system.factorise());
    expect_solved(system, Matrix::Identity(n, n));
  }
}

}  // namespace
}  // namespace odeum::linear::dense_system_test
