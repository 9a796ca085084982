// SPDX-License-Identifier: BSD-3-Clause
// Band and sparse factors against dense ones in extended precision on random patterns, also of
// matrices that are singular or badly scaled.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "odeum/linear/sparse_system.hpp"

namespace odeum::tests::direct_solvers_test {
namespace {

class RandomPatterns : public testing::TestWithParam<unsigned> {
 protected:
  std::size_t below(std::size_t n) { return random_() % n; }
  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

  /// Rows of up to `most` entries anywhere, the diagonal not always among them.
  Sparsity pattern(std::size_t n, std::size_t most) {
    Sparsity s;
    for (std::size_t i = 0; i < n; ++i) {
      std::set<int> row;
      for (std::size_t k = 0; k < most; ++k) row.insert(static_cast<int>(below(n)));
      s.add_row({row.begin(), row.end()});
    }
    return s;
  }
  Eigen::MatrixXd dense(const Sparsity& s, const std::vector<double>& values, double g) {
    const auto n = static_cast<Eigen::Index>(s.unknowns());
    Eigen::MatrixXd m = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (int k = s.start[i]; k < s.start[i + 1]; ++k) m(i, s.column[k]) -= g * values[k];
    return m;
  }
  static JacobianEntries constant(const std::vector<double>& values) {
    return [values](double, const double*, double* out) {
      std::copy(values.begin(), values.end(), out);
    };
  }

  std::mt19937 random_{GetParam()};
};

/// The residual, by rows, of the terms that it is made of.
double residual(const Eigen::MatrixXd& m, const Eigen::VectorXd& x, const Eigen::VectorXd& right) {
  const Eigen::VectorXd apart = (m * x - right).cwiseAbs();
  const double size = m.cwiseAbs().rowwise().sum().maxCoeff() * x.cwiseAbs().maxCoeff() +
                      right.cwiseAbs().maxCoeff();
  return apart.maxCoeff() / size;
}

TEST_P(RandomPatterns, AreSolvedAsByDenseFactors) {
  // Few unknowns are a band, many that are coupled anywhere are not.
  for (const std::size_t n : {std::size_t{1}, 2 + below(8), 20 + below(20), 150 + below(60)})
    for (const bool badly_scaled : {false, true}) {
      const Sparsity s = pattern(n, 1 + below(4));
      std::vector<double> values(s.entries());
      for (double& value : values)
        value = uniform() * (badly_scaled ? std::pow(10.0, 12 * uniform()) : 1);
      SparseSystem system(s, constant(values), 1);
      const std::vector<double> y(n);
      system.linearise(0, y.data());
      const Eigen::MatrixXd m = dense(s, values, 0.7);
      Eigen::VectorXd right(static_cast<Eigen::Index>(n));
      for (double& r : right) r = uniform();
      SCOPED_TRACE(system.method() + ", " + std::to_string(n) +
                   (badly_scaled ? ", badly scaled" : ""));
      using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
      const Eigen::PartialPivLU<Extended> lu(m.cast<long double>());
      const auto rcond = static_cast<double>(lu.rcond());
      if (!system.factorise(0, 0.7)) {
        // Only where a pivot is lost in rounding: none of these is exactly singular.
        EXPECT_LT(rcond, 1e-12);
        continue;
      }
      Eigen::VectorXd x = right;
      system.solve(0, x.data(), nullptr);
      ASSERT_TRUE(x.allFinite());
      // Partial pivoting is stable but for a growth of the pivots, of a few tens at most here.
      EXPECT_LE(residual(m, x, right), 1e-13);
      if (!(rcond > 1e-10)) continue;
      const Eigen::VectorXd exact = lu.solve(right.cast<long double>()).cast<double>();
      EXPECT_LE((x - exact).cwiseAbs().maxCoeff(), 1e-13 / rcond * exact.cwiseAbs().maxCoeff());
    }
}

/// One row of I - J is zero.
TEST_P(RandomPatterns, SingularOnesAreRefused) {
  for (const std::size_t n : {std::size_t{3}, 20 + below(20), 150 + below(60)}) {
    const Sparsity anywhere = pattern(n, 3);
    const auto row = below(n);
    Sparsity s;
    for (std::size_t i = 0; i < n; ++i) {
      std::set<int> columns(anywhere.column.begin() + anywhere.start[i],
                            anywhere.column.begin() + anywhere.start[i + 1]);
      if (i == row) columns = {static_cast<int>(i)};
      s.add_row({columns.begin(), columns.end()});
    }
    std::vector<double> values(s.entries());
    for (double& value : values) value = uniform();
    values[static_cast<std::size_t>(s.start[row])] = 1;  // the row of I - J is zero
    SparseSystem system(s, constant(values), 1);
    const std::vector<double> y(n);
    system.linearise(0, y.data());
    EXPECT_FALSE(system.factorise(0, 1)) << system.method() << ", " << n;
    // The same factors serve another shift afterwards.
    ASSERT_TRUE(system.factorise(0, 0.25)) << system.method() << ", " << n;
    Eigen::VectorXd x = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(n));
    system.solve(0, x.data(), nullptr);
    EXPECT_LE(residual(dense(s, values, 0.25), x, Eigen::VectorXd::Ones(x.size())), 1e-13);
  }
}

TEST_P(RandomPatterns, ValuesThatAreNotFiniteAreRefused) {
  const Sparsity s = pattern(30 + below(150), 3);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<double> values(s.entries(), 0.1);
    values[below(values.size())] = bad;
    SparseSystem system(s, constant(values), 1);
    const std::vector<double> y(s.unknowns());
    system.linearise(0, y.data());
    EXPECT_FALSE(system.factorise(0, 0.5)) << system.method();
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPatterns, testing::Range(1U, 21U));

}  // namespace
}  // namespace odeum::tests::direct_solvers_test
