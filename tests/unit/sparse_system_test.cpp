// SPDX-License-Identifier: BSD-3-Clause
// long: one test of each solver and of what follows from a sparsity
// Direct solvers of band and sparse matrices against a dense one, and runs of every solver on a
// problem that states its sparsity against the same problem without it.
#include "odeum/linear/sparse_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "odeum/core/guarded.hpp"
#include "odeum/linear/banded_lu.hpp"
#include "odeum/linear/ordering.hpp"
#include "support/stage.hpp"

namespace odeum::tests {
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

Eigen::MatrixXcd dense(const Sparsity& s, const std::vector<double>& values, Complex g) {
  const auto n = static_cast<Eigen::Index>(s.unknowns());
  Eigen::MatrixXcd m = Eigen::MatrixXcd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (int k = s.start[i]; k < s.start[i + 1]; ++k) m(i, s.column[k]) -= g * values[k];
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

void expect_solves(const Sparsity& s, Complex g, const std::string& how) {
  const std::vector<double> values = random_values(s.entries(), 7);
  SparseSystem system(s, constant_entries(values), 2);
  EXPECT_NE(system.method().find(how), std::string::npos) << system.method();
  const std::vector<double> y(s.unknowns());
  system.linearise(0, y.data());
  ASSERT_TRUE(system.factorise(1, g));
  const Eigen::MatrixXcd m = dense(s, values, g);
  const auto n = static_cast<Eigen::Index>(s.unknowns());
  Eigen::VectorXcd right(n);
  for (Eigen::Index i = 0; i < n; ++i)
    right[i] = {std::sin(1.0 + static_cast<double>(i)),
                g.imag() == 0 ? 0 : std::cos(static_cast<double>(2 * i))};
  Eigen::VectorXd re = right.real(), im = right.imag();
  system.solve(1, re.data(), g.imag() == 0 ? nullptr : im.data());
  const Eigen::VectorXcd residual = m * (re.cast<Complex>() + Complex(0, 1) * im) - right;
  // Rounding of a stable elimination, whose solution is larger than the right side by |m^-1|.
  const double size =
      std::max(1.0, re.cwiseAbs().maxCoeff()) * m.cwiseAbs().rowwise().sum().maxCoeff();
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
  const std::vector<int> order = linear::reverse_cuthill_mckee(s);
  std::vector<int> number(order.size(), -1);
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<int>(k);
  EXPECT_EQ(std::count(number.begin(), number.end(), -1), 0) << "a permutation";
  const auto [lower, upper] = linear::bandwidths(s, number);
  // A ladder of 50 rungs: two unknowns a level, and a level is coupled with the next.
  EXPECT_LE(lower, 3U);
  EXPECT_LE(upper, 3U);
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

/// y_i' = y_{i-1} - 2 y_i + y_{i+1} - y_i^3 + sin(t), with zeros beyond the ends.
struct Diffusion {
  static constexpr std::size_t dimension = dynamic;
  static constexpr int n = 40;
  static constexpr double stiffness = 200;
  void rhs(double t, const double* y, double* f) const {
    for (int i = 0; i < n; ++i)
      f[i] = stiffness * ((i > 0 ? y[i - 1] : 0) - 2 * y[i] + (i + 1 < n ? y[i + 1] : 0)) -
             y[i] * y[i] * y[i] + std::sin(t);
  }
  void time_derivative(double t, const double*, double* d) const {
    for (int i = 0; i < n; ++i) d[i] = std::cos(t);
  }
  static std::size_t size() { return n; }
};
struct DenseDiffusion : Diffusion {
  void jacobian(double, const double* y, double* j) const {
    std::fill(j, j + n * n, 0.0);
    for (int i = 0; i < n; ++i) {
      j[i * n + i] = -2 * stiffness - 3 * y[i] * y[i];
      if (i > 0) j[i * n + i - 1] = stiffness;
      if (i + 1 < n) j[i * n + i + 1] = stiffness;
    }
  }
};
struct DifferencedDiffusion : Diffusion {
  Sparsity pattern = banded_sparsity(n, 1, 1);
  const Sparsity* sparsity() const { return &pattern; }
};
struct BandedDiffusion : DifferencedDiffusion {
  void jacobian_entries(double, const double* y, double* values) const {
    for (int i = 0; i < n; ++i)
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        values[k] = pattern.column[k] == i ? -2 * stiffness - 3 * y[i] * y[i] : stiffness;
  }
};

TEST(DifferencedEntries, TakeOneEvaluationMoreThanColours) {
  const BandedDiffusion banded;
  const DifferencedDiffusion differenced;
  const SharedOde problem{view_of(differenced), nullptr};
  Guard guard(Diffusion::n, {});
  const Guarded<SharedOde> guarded(problem, guard);
  std::vector<double> y(Diffusion::n), exact(banded.pattern.entries()), values(exact.size());
  for (int i = 0; i < Diffusion::n; ++i) y[i] = std::sin(i);
  banded.jacobian_entries(0, y.data(), exact.data());
  entries_of(guarded)(0, y.data(), values.data());
  EXPECT_EQ(guard.rhs_evaluations(), 4U);
  EXPECT_EQ(guard.jacobian_evaluations(), 0U);
  // y_0 = 0 is moved by 5e-11, in which the rounding of f, 200 times 2e-16, is 1e-3.
  for (std::size_t k = 0; k < exact.size(); ++k) EXPECT_NEAR(values[k], exact[k], 5e-3) << k;
}

TEST(Sparse, DenseFormAndProductFollowFromTheEntries) {
  const BandedDiffusion banded;
  const DenseDiffusion full;
  const OdeView view = view_of(banded);
  std::vector<double> y(Diffusion::n), x(Diffusion::n), j(Diffusion::n * Diffusion::n), d(j),
      product(Diffusion::n);
  for (int i = 0; i < Diffusion::n; ++i) y[i] = std::sin(i), x[i] = std::cos(i);
  view.jacobian(view.problem, 0, y.data(), j.data());
  full.jacobian(0, y.data(), d.data());
  EXPECT_EQ(j, d);
  view.jacobian_times(view.problem, 0, y.data(), x.data(), product.data());
  for (int i = 0; i < Diffusion::n; ++i) {
    double sum = 0;
    for (int k = 0; k < Diffusion::n; ++k) sum += d[i * Diffusion::n + k] * x[k];
    EXPECT_NEAR(product[i], sum, 1e-12 * 600) << i;  // rounding of sums of that size
  }
}

template <class P>
Case stage_of() {
  Case c;
  c.y0.assign(Diffusion::n, 0.0);
  for (int i = 0; i < Diffusion::n; ++i) c.y0[i] = std::sin(3.0 * (i + 1) / (Diffusion::n + 1));
  c.stops = {0.05};
  cases::set_stage(c, P{});
  return c;
}

/// The same steps and states by band, by differences in a band and by dense matrices.
TEST(Sparse, EverySolverMakesTheSameRun) {
  const Case full = stage_of<DenseDiffusion>(), banded = stage_of<BandedDiffusion>(),
             differenced = stage_of<DifferencedDiffusion>();
  int implicit = 0;
  for (std::size_t e = 0; e < full.entrants.size(); ++e) {
    const Entrant& entrant = full.entrants[e];
    ASSERT_EQ(entrant.info.id(), banded.entrants[e].info.id());
    EXPECT_EQ(entrant.unfit.empty(), banded.entrants[e].unfit.empty()) << entrant.info.id();
    if (!entrant.solve || entrant.info.library == "bullet") continue;
    Request request;
    request.stops = full.stops;
    request.budget.evaluations = 20'000;
    if (entrant.info.fixed)
      request.mode = Mode::fixed, request.steps = 50;
    else
      request.mode = Mode::adaptive, request.tolerance = 1e-5;
    const Outcome a = entrant.solve(request), b = banded.entrants[e].solve(request),
                  c = differenced.entrants[e].solve(request);
    EXPECT_EQ(a.status, b.status) << entrant.info.id() << ": " << b.detail;
    EXPECT_EQ(a.status, c.status) << entrant.info.id() << ": " << c.detail;
    if (a.status != Status::ok) continue;
    implicit += a.counters.jacobian_evaluations > 0;
    double difference = 0, rough = 0;
    for (std::size_t i = 0; i < a.states.size(); ++i) {
      difference = std::max(difference, std::abs(a.states[i] - b.states[i]));
      rough = std::max(rough, std::abs(a.states[i] - c.states[i]));
    }
    // Rounding of other factors; a Newton iteration ends within 1e-13, an adaptive one within the
    // tolerance, and its steps follow from that.
    EXPECT_LE(difference, entrant.info.fixed ? 1e-10 : 1e-5) << entrant.info.id();
    // A linearly implicit method keeps the error of J, 3e-8 of it, in its solution.
    EXPECT_LE(rough, entrant.info.fixed ? 1e-6 : 1e-5) << entrant.info.id();
  }
  EXPECT_GT(implicit, 25);
}

}  // namespace
}  // namespace odeum::tests
