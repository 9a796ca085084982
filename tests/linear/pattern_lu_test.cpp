// SPDX-License-Identifier: BSD-3-Clause
// Elimination by a list of places against a dense matrix.
#include "odeum/linear/pattern_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace odeum::linear::pattern_lu_test {
namespace {

struct Random {
  std::mt19937 engine{7};
  double operator()() { return std::uniform_real_distribution<double>(-1, 1)(engine); }
  bool one_in(int many) { return std::uniform_int_distribution<int>(1, many)(engine) == 1; }
};

Sparsity random_pattern(std::size_t n, Random& random) {
  Sparsity pattern;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<int> row;
    for (std::size_t j = 0; j < n; ++j)
      if (random.one_in(6)) row.push_back(static_cast<int>(j));
    pattern.add_row(row);
  }
  return pattern;
}

template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

template <class Scalar>
Matrix<Scalar> dense(const Sparsity& s, const std::vector<double>& values, Scalar g) {
  const auto n = static_cast<Eigen::Index>(s.unknowns());
  Matrix<Scalar> m = Matrix<Scalar>::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (int k = s.start[i]; k < s.start[i + 1]; ++k) m(i, s.column[k]) -= g * values[k];
  return m;
}

/// Whether it is the solution of the dense matrix, to rounding times what elimination may lose.
template <class Scalar>
void expect_solution(const Sparsity& pattern, const std::vector<double>& values, Scalar g) {
  PatternLu<Scalar> lu(pattern, elimination_of(pattern));
  ASSERT_TRUE(lu.factorise(values, g));
  const Matrix<Scalar> m = dense(pattern, values, g);
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> right(m.rows());
  for (Eigen::Index i = 0; i < m.rows(); ++i) right[i] = Scalar(1.0 / static_cast<double>(i + 1));
  auto x = right;
  lu.solve(x.data());
  EXPECT_LT((m * x - right).norm(), 1e-10 * (m.norm() * x.norm() + right.norm()));
}

TEST(PatternLu, SolvesAsADenseMatrixDoes) {
  Random random;
  for (std::size_t n = 1; n <= Elimination::few_unknowns; n = n * 3 / 2 + 1) {
    SCOPED_TRACE(n);
    const Sparsity pattern = random_pattern(n, random);
    std::vector<double> values(pattern.entries());
    for (double& value : values) value = random();
    for (const double g : {1e-3, 0.3, 50.0}) {
      expect_solution<double>(pattern, values, g);
      expect_solution<std::complex<double>>(pattern, values, {g, -0.7 * g});
    }
  }
}

// I - J has a zero on its diagonal, or nearly so, which needs an exchange of rows.
TEST(PatternLu, ExchangesRowsWhereAPivotVanishes) {
  Sparsity pattern;
  pattern.add_row({0, 1});
  pattern.add_row({0, 1, 2});
  pattern.add_row({1, 2});
  for (const double first : {1.0, 1.0 - 1e-12})
    expect_solution<double>(pattern, {first, 2, -3, 0.5, 1, 2, 0.5}, 1.0);
}

TEST(PatternLu, RefusesWhatIsSingularOrNotFinite) {
  Sparsity pattern;
  pattern.add_row({0, 1});
  pattern.add_row({0, 1});
  PatternLu<double> lu(pattern, elimination_of(pattern));
  EXPECT_FALSE(lu.factorise({0, 1, 1, 0}, 1.0));  // 1, -1; -1, 1
  EXPECT_FALSE(lu.factorise({0, std::nan(""), 1, 0}, 1.0));
  EXPECT_TRUE(lu.factorise({0, 1, 1, 0}, 0.5));
}

// The truth has factors of more unknowns, in extended precision.
TEST(PatternLu, SolvesForManyUnknownsAndRefusesTooManyMultiplications) {
  Random random;
  for (const int n : {300, 1500}) {
    SCOPED_TRACE(n);
    // A tree with its leaves first, whose elimination adds nothing.
    Sparsity pattern;
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
      const int root = n - 1 - (n - 1 - i) / 3;
      rows[static_cast<std::size_t>(i)].push_back(i);
      if (root == i) continue;
      rows[static_cast<std::size_t>(i)].push_back(root);
      rows[static_cast<std::size_t>(root)].push_back(i);
    }
    for (auto& row : rows) {
      std::sort(row.begin(), row.end());
      pattern.add_row(row);
    }
    std::vector<double> values(pattern.entries());
    for (double& value : values) value = random();
    const auto how = std::make_shared<const Elimination>(pattern);
    EXPECT_EQ(how->column.size(), pattern.entries());
    PatternLu<long double> lu(pattern, how);
    ASSERT_TRUE(lu.factorise(values, 0.05L));
    std::vector<long double> x(static_cast<std::size_t>(n), 1);
    lu.solve(x.data());
    for (std::size_t i = 0; i < x.size(); ++i) {
      long double left = x[i];
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        left -= 0.05L * values[static_cast<std::size_t>(k)] *
                x[static_cast<std::size_t>(pattern.column[static_cast<std::size_t>(k)])];
      EXPECT_NEAR(static_cast<double>(left), 1, 1e-17);  // some roundings of extended precision
    }
    EXPECT_THROW(Elimination(pattern, 10), std::length_error);
  }
}

TEST(PatternLu, ChoosesAnOrderWithoutFill) {
  // An arrow whose tip is the first unknown: elimination in the given order fills the matrix.
  Sparsity arrow;
  constexpr int n = 30;
  std::vector<int> all;
  for (int j = 0; j < n; ++j) all.push_back(j);
  arrow.add_row(all);
  for (int i = 1; i < n; ++i) arrow.add_row({0, i});
  EXPECT_EQ(Elimination(arrow).column.size(), static_cast<std::size_t>(3 * n - 2));
}

}  // namespace
}  // namespace odeum::linear::pattern_lu_test
