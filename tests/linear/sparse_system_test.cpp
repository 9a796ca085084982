// SPDX-License-Identifier: BSD-3-Clause
// Direct solvers of band and sparse matrices: the residuals of their solutions.
#include "odeum/linear/sparse_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <cmath>
#include <limits>
#include <random>

#include "odeum/linear/banded_lu.hpp"
#include "odeum/linear/ordering.hpp"

namespace odeum::tests::sparse_system_test {
namespace {

using Complex = std::complex<double>;

/// Values of a pattern, the same at every point.
JacobianEntries constant_entries(std::vector<double> values) {
  return [values = std::move(values)](double, const double*, double* out) {
    std::copy(values.begin(), values.end(), out);
  };
}

std::vector<double> random_values(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> values(count);
  for (double& value : values) value = uniform(random);
  return values;
}

/// I - g times the pattern with those values.
Eigen::SparseMatrix<Complex> shifted(const Sparsity& s, const std::vector<double>& values,
                                     Complex g) {
  const auto n = static_cast<int>(s.unknowns());
  std::vector<Eigen::Triplet<Complex>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 1);
    for (int k = s.start[i]; k < s.start[i + 1]; ++k)
      entries.emplace_back(i, s.column[k], -g * values[k]);
  }
  Eigen::SparseMatrix<Complex> m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

/// Neighbours on a square grid, numbered row by row, and a coupling from afar.
Sparsity grid(int side) {
  Sparsity s;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      std::vector<int> row{i * side + j};
      if (i > 0) row.push_back((i - 1) * side + j);
      if (j > 0) row.push_back(i * side + j - 1);
      if (j + 1 < side) row.push_back(i * side + j + 1);
      if (i + 1 < side) row.push_back((i + 1) * side + j);
      s.add_row(row);
    }
  return s;
}

/// u_1, ..., u_n, v_1, ..., v_n of a reaction with diffusion: wide as it is numbered.
Sparsity reaction(int n) {
  Sparsity s;
  for (int species = 0; species < 2; ++species)
    for (int i = 0; i < n; ++i) {
      std::vector<int> row{i, n + i};
      if (i > 0) row.push_back(species * n + i - 1);
      if (i + 1 < n) row.push_back(species * n + i + 1);
      s.add_row(row);
    }
  return s;
}

/// Each species with two of any others and with three that all have.
Sparsity network(int n) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(3, n - 1);
  Sparsity s;
  for (int i = 0; i < n; ++i) {
    std::vector<int> row{0, 1, 2, i, any(random), any(random)};
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    s.add_row(row);
  }
  return s;
}

void expect_solves(const Sparsity& s, Complex g, const std::string& how) {
  const std::vector<double> values = random_values(s.entries(), 7);
  SparseSystem system(s, constant_entries(values), 2);
  EXPECT_NE(system.method().find(how), std::string::npos) << system.method();
  const std::vector<double> y(s.unknowns());
  system.linearise(0, y.data());
  ASSERT_TRUE(system.factorise(1, g));
  const Eigen::SparseMatrix<Complex> m = shifted(s, values, g);
  const auto n = static_cast<Eigen::Index>(s.unknowns());
  Eigen::VectorXcd right(n);
  for (Eigen::Index i = 0; i < n; ++i)
    right[i] = {std::sin(1.0 + static_cast<double>(i)),
                g.imag() == 0 ? 0 : std::cos(static_cast<double>(2 * i))};
  Eigen::VectorXd re = right.real(), im = right.imag();
  system.solve(1, re.data(), g.imag() == 0 ? nullptr : im.data());
  const Eigen::VectorXcd residual = m * (re.cast<Complex>() + Complex(0, 1) * im) - right;
  // Rounding of a stable elimination, whose solution is larger than the right side by |m^-1|.
  const double size = std::max(1.0, re.cwiseAbs().maxCoeff()) *
                      (m.cwiseAbs() * Eigen::VectorXd::Ones(n)).maxCoeff();
  EXPECT_LE(residual.cwiseAbs().maxCoeff(), 1e-13 * size) << system.method();
}

TEST(SparseSystem, SolvesBandsAndOthersInRealAndComplexNumbers) {
  for (const Complex g : {Complex(0.3), Complex(40), Complex(0.3, 0.2), Complex(40, 90)}) {
    expect_solves(banded_sparsity(1, 0, 0), g, "band of 0");
    expect_solves(banded_sparsity(37, 1, 1), g, "band of 1 below and 1 above");
    expect_solves(banded_sparsity(37, 3, 0), g, "band of 3 below and 0 above");
    expect_solves(banded_sparsity(37, 0, 2), g, "band of 0 below and 2 above");
    expect_solves(banded_sparsity(5, 4, 4), g, "band of 4");
    expect_solves(reaction(40), g, "band of");
    expect_solves(grid(10), g, "band of");
    expect_solves(grid(70), g, "sparse LU");
    // Without exchanges of rows at the first, which these values allow, and with them at others.
    expect_solves(network(200), g, "LU of the pattern's entries");
  }
}

TEST(SparseSystem, ExchangesRowsOfANarrowBandOnlyWhereItMust) {
  const Sparsity s = banded_sparsity(40, 1, 1);
  std::vector<double> values(s.entries(), 1.0);
  for (const int row : {3, 36}) values[s.start[row] + 1] = 2.0;  // its diagonal
  SparseSystem system(s, constant_entries(values), 1);
  const std::vector<double> y(s.unknowns());
  system.linearise(0, y.data());
  for (const double g : {0.2, 0.5, 0.2}) {  // at 0.5 the second pivot would be zero
    ASSERT_TRUE(system.factorise(0, g));
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(40, -1, 2);
    const Eigen::VectorXd right = x;
    system.solve(0, x.data(), nullptr);
    const Eigen::VectorXd rest = shifted(s, values, g).real() * x - right;
    EXPECT_LE(rest.cwiseAbs().maxCoeff(), 1e-13 * std::max(1.0, x.cwiseAbs().maxCoeff())) << g;
  }
}

TEST(SparseSystem, SaysWhenTheMatrixIsSingularOrNotFinite) {
  const std::vector<double> y(3);
  for (const Sparsity& s : {banded_sparsity(3, 1, 1)}) {
    std::vector<double> values(s.entries(), 0.0);
    for (int i = 0; i < 3; ++i)
      for (int k = s.start[i]; k < s.start[i + 1]; ++k)
        if (s.column[k] == i) values[k] = 1;
    SparseSystem identity(s, constant_entries(values), 1);
    identity.linearise(0, y.data());
    EXPECT_TRUE(identity.factorise(0, 0.5));
    EXPECT_FALSE(identity.factorise(0, 1));  // I - J = 0
    values[0] = std::numeric_limits<double>::quiet_NaN();
    SparseSystem lost(s, constant_entries(values), 1);
    lost.linearise(0, y.data());
    EXPECT_FALSE(lost.factorise(0, 0.5));
  }
}

TEST(SparseSystem, EvaluatesOnceAtAPoint) {
  const Sparsity s = banded_sparsity(2, 0, 0);
  int calls = 0;
  SparseSystem system(
      s,
      [&](double, const double*, double* values) {
        values[0] = values[1] = -1;
        ++calls;
      },
      1);
  const double here[] = {1, 2}, there[] = {1, 3};
  system.linearise(0, here);
  system.linearise(0, here);
  EXPECT_EQ(calls, 1);
  system.linearise(0, there);
  system.linearise(1, there);
  EXPECT_EQ(calls, 3);
}

TEST(SparseSystem, RefusesWhatIsNoPattern) {
  Sparsity unordered;
  unordered.start = {0, 2, 2};
  unordered.column = {1, 0};
  EXPECT_THROW(SparseSystem(unordered, constant_entries({1, 1}), 1), std::invalid_argument);
  Sparsity outside = banded_sparsity(2, 0, 0);
  outside.column[1] = 2;
  EXPECT_THROW(SparseSystem(outside, constant_entries({1, 1}), 1), std::invalid_argument);
}

TEST(Ordering, NarrowsTheBandOfTwoSpecies) {
  const Sparsity s = reaction(50);
  const linear::Band band = linear::band_of(s, linear::reverse_cuthill_mckee(s));
  EXPECT_TRUE(
      std::is_permutation(band.order.begin(), band.order.end(), linear::band_of(s).order.begin()));
  for (std::size_t k = 0; k < band.order.size(); ++k)
    EXPECT_EQ(band.number[band.order[k]], static_cast<int>(k));
  // A ladder of 50 rungs: two unknowns a level, and a level is coupled with the next.
  EXPECT_LE(band.lower, 3U);
  EXPECT_LE(band.upper, 3U);
}

TEST(Colouring, ColumnsOfAColourShareNoRow) {
  for (const auto& [s, most] :
       {std::pair{banded_sparsity(30, 1, 1), 3}, std::pair{banded_sparsity(30, 2, 1), 4},
        std::pair{grid(9), 9}, std::pair{reaction(20), 7}}) {
    const std::vector<int> colour = column_colours(s);
    // A greedy choice needs at most one more than the columns that share a row with a column.
    EXPECT_LE(*std::max_element(colour.begin(), colour.end()), most - 1);
    for (std::size_t i = 0; i < s.unknowns(); ++i)
      for (int a = s.start[i]; a < s.start[i + 1]; ++a)
        for (int b = a + 1; b < s.start[i + 1]; ++b)
          EXPECT_NE(colour[s.column[a]], colour[s.column[b]]) << "row " << i;
  }
}

}  // namespace
}  // namespace odeum::tests::sparse_system_test
