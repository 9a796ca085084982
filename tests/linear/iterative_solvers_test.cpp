// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/iterative_solvers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "odeum/fem/shapes.hpp"
#include "odeum/linear/eigen_solvers.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/studies/elements/problems.hpp"

namespace odeum::linear::iterative_solvers_test {
namespace {

using std::numbers::pi;

SparseMatrix dense(const std::vector<std::vector<double>>& rows) {
  std::vector<Triplet> entries;
  const auto n = static_cast<int>(rows.size());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (rows[i][j] != 0) entries.push_back({i, j, rows[i][j]});
  return from_triplets(n, n, entries);
}

TEST(SparseMatrix, AddsEntriesOfOnePlace) {
  const SparseMatrix a = from_triplets(2, 3, {{1, 2, 3}, {0, 0, 1}, {1, 2, 0.5}});
  EXPECT_EQ(a.at(1, 2), 3.5);
  EXPECT_EQ(a.at(0, 1), 0);
  EXPECT_THROW(from_triplets(2, 2, {{2, 0, 1}}), std::out_of_range);
  EXPECT_THROW(from_triplets(2, 2, {{0, -1, 1}}), std::out_of_range);
  const SparseMatrix p = from_triplets(2, 1, {{0, 0, 1}, {1, 0, 2}});
  const SparseMatrix product = galerkin_product(dense({{2, 1}, {1, 3}}), p);
  EXPECT_EQ(product.at(0, 0), 2 + 2 * 2 + 4 * 3);
  EXPECT_THROW(galerkin_product(dense({{1}}), p), std::invalid_argument);
}

TEST(Tridiagonal, ExtremesOfSecondDifferences) {
  for (const std::size_t n : {1, 2, 7, 100}) {
    const auto [low, high] =
        extreme_eigenvalues(std::vector<double>(n, 2), std::vector<double>(n - 1, -1));
    const double angle = pi / (static_cast<double>(n) + 1);
    EXPECT_NEAR(low, 2 - 2 * std::cos(angle), 1e-14) << n;
    EXPECT_NEAR(high, 2 + 2 * std::cos(angle), 1e-14) << n;
  }
}

/// The five-point star of 16 x 16 divisions.
class FivePoint : public ::testing::Test {
 protected:
  study::ModelProblem model_ = study::smooth_problem();
  study::Hierarchy hierarchy_{model_, 16};
  const SparseMatrix& a_ = hierarchy_.finest().system.matrix;
  std::vector<double> b_ = std::vector<double>(a_.rows), exact_ = b_;

  void SetUp() override {
    for (std::size_t i = 0; i < b_.size(); ++i)
      b_[i] = std::sin(static_cast<double>(i * i));  // no symmetry
    SparseLdlt(a_).solve(b_.data(), exact_.data());
  }
  void expect_solved(const IterativeOutcome& outcome) {
    EXPECT_EQ(outcome.status, IterationStatus::converged);
    EXPECT_EQ(outcome.residuals.size(), outcome.iterations + 1);
    EXPECT_LE(outcome.residuals.back(), 1e-10);
    // No component is further off, since |A^-1| < 14 and |b| < 12.
    for (std::size_t i = 0; i < exact_.size(); ++i)
      ASSERT_NEAR(outcome.x[i], exact_[i], 14 * 12 * 1e-10);
  }
};

TEST_F(FivePoint, EverySolverReachesTheDirectSolution) {
  const StopRule rule{.relative_residual = 1e-10};
  const JacobiPreconditioner diagonal(a_);
  const Multigrid multigrid = hierarchy_.multigrid();
  EXPECT_EQ(multigrid.levels(), 4U);
  expect_solved(stationary(a_, diagonal, b_, rule));
  expect_solved(gauss_seidel(a_, b_, rule));
  expect_solved(steepest_descent(a_, b_, rule));
  expect_solved(stationary(a_, multigrid, b_, rule));
  for (const Preconditioner* m :
       std::initializer_list<const Preconditioner*>{&diagonal, &multigrid})
    expect_solved(preconditioned_cg(a_, *m, b_, rule));
  expect_solved(preconditioned_cg(a_, NoPreconditioner(a_), b_, rule));
  expect_solved(preconditioned_cg(a_, SsorPreconditioner(a_, 1.5), b_, rule));
  expect_solved(preconditioned_cg(a_, IncompleteCholesky(a_), b_, rule));
}

TEST_F(FivePoint, PeersSolveIt) {
  std::set<std::string> seen;
  for (const LinearPeerInfo& info : linear_peers()) {
    const auto peer = info.set_up(a_);
    std::vector<double> x;
    // Twice: nothing is left of the first solve.
    for (int k = 0; k < 2; ++k) {
      const std::size_t iterations = peer->solve(b_, x, 1e-10, 1000);
      EXPECT_EQ(iterations == 0, info.direct) << info.id;
      for (std::size_t i = 0; i < x.size(); ++i)
        ASSERT_NEAR(x[i], exact_[i], 14 * 12 * 1e-10) << info.id;
    }
    // With a tolerance of 0 exactly as many iterations as asked for.
    if (!info.direct) {
      EXPECT_EQ(peer->solve(b_, x, 0, 3), 3U) << info.id;
      EXPECT_GT(residual_norm(a_, x, b_), 1e-6) << info.id;
    }
    seen.insert(info.id.substr(0, info.id.find('/')));
  }
  EXPECT_TRUE(seen.contains("eigen"));
  for (const LibraryInfo& library : all_libraries())
    if (library.built &&
        (library.name == "cholmod" || library.name == "gsl" || library.name == "sundials")) {
      EXPECT_TRUE(seen.contains(library.name)) << library.name;
    }
}

TEST(LinearPeers, RefuseWhatIsNotPositiveDefinite) {
  const SparseMatrix indefinite = from_triplets(2, 2, {{0, 0, 1}, {0, 1, 2}, {1, 0, 2}, {1, 1, 1}});
  for (const LinearPeerInfo& info : linear_peers())
    if (info.direct) {
      EXPECT_THROW(info.set_up(indefinite), std::invalid_argument) << info.id;
    }
}

// Eigenvalues 4 - 2 cos(i pi / n) - 2 cos(j pi / n).
TEST_F(FivePoint, SpectrumIsThatOfTheClosedForm) {
  const StopRule rule{.relative_residual = 1e-13};
  const double c = std::cos(pi / 16);
  const CgOutcome plain = preconditioned_cg(a_, NoPreconditioner(a_), b_, rule);
  EXPECT_NEAR(plain.lowest, 4 - 4 * c, 1e-8);
  EXPECT_NEAR(plain.highest, 4 + 4 * c, 1e-8);
  const CgOutcome diagonal = preconditioned_cg(a_, JacobiPreconditioner(a_), b_, rule);
  EXPECT_NEAR(diagonal.lowest, 1 - c, 1e-8);
  EXPECT_NEAR(diagonal.highest, 1 + c, 1e-8);
  // Asymptotic rates: c of Jacobi, by Young c^2 of Gauss-Seidel.
  const auto rate = [](const IterativeOutcome& run) {
    const std::size_t last = run.residuals.size() - 1;
    return run.residuals[last] / run.residuals[last - 1];
  };
  const StopRule far{.relative_residual = 1e-12};
  EXPECT_NEAR(rate(gauss_seidel(a_, b_, far)), c * c, 1e-4);
  EXPECT_NEAR(rate(stationary(a_, JacobiPreconditioner(a_), b_, far)), c, 1e-3);
}

TEST_F(FivePoint, MultigridTakesAsManyIterationsOnAnyMesh) {
  const study::Hierarchy finer(model_, 64);
  const SparseMatrix& a = finer.finest().system.matrix;
  const StopRule rule{.relative_residual = 1e-10};
  const std::size_t coarse = preconditioned_cg(a_, hierarchy_.multigrid(), b_, rule).iterations;
  const std::vector<double> b(a.rows, 1);
  const CgOutcome fine = preconditioned_cg(a, finer.multigrid(), b, rule);
  EXPECT_EQ(fine.status, IterationStatus::converged);
  EXPECT_NEAR(static_cast<double>(fine.iterations), static_cast<double>(coarse), 3);
  // A symmetric V-cycle is an approximation from above: no eigenvalue above 1.
  EXPECT_LT(fine.highest, 1 + 1e-10);
  EXPECT_GT(fine.lowest, 0.5);
}

TEST_F(FivePoint, StopsWhereItIsToldTo) {
  const NoPreconditioner none(a_);
  const auto three = [](std::size_t iteration, const double*) { return iteration < 3; };
  const StopRule rule;
  const auto ended = [](const IterativeOutcome& run, IterationStatus status,
                        std::size_t iterations) {
    EXPECT_EQ(run.status, status);
    EXPECT_EQ(run.iterations, iterations);
  };
  ended(preconditioned_cg(a_, none, b_, rule, three), IterationStatus::stopped, 3);
  ended(gauss_seidel(a_, b_, rule, three), IterationStatus::stopped, 3);
  const StopRule short_rule{.most_iterations = 5};
  ended(preconditioned_cg(a_, none, b_, short_rule), IterationStatus::over_budget, 5);
  ended(steepest_descent(a_, b_, short_rule), IterationStatus::over_budget, 5);
  const std::vector<double> zero(b_.size());
  EXPECT_EQ(preconditioned_cg(a_, none, zero, rule).status, IterationStatus::converged);
  EXPECT_EQ(gauss_seidel(a_, zero, rule).iterations, 0U);
}

// A tridiagonal matrix has no fill: the incomplete factors are the complete ones.
// More rows than a block, so that threads share the sweeps.
TEST(Threads, MakeNoDifferenceToTheBits) {
  const fem::EllipticProblem problem{.load = [](fem::Point p) { return p.x * (1 - p.y); }};
  fem::Levels levels(problem, fem::vertex_rule());
  levels.add(fem::unit_square(11));
  for (int k = 0; k < 4; ++k) levels.add(fem::refined(levels.finest().mesh));
  const auto& system = levels.finest().system;
  ASSERT_GT(system.right.size(), 16384U);
  const auto solve = [&](std::size_t threads) {
    const Multigrid m = levels.multigrid(levels.size() - 1, threads);
    return preconditioned_cg(system.matrix, m, system.right, {}, {}, threads);
  };
  const CgOutcome one = solve(1), two = solve(2);
  EXPECT_EQ(one.status, IterationStatus::converged);
  EXPECT_LE(one.iterations, 10U);
  EXPECT_EQ(one.residuals, two.residuals);
  EXPECT_EQ(one.x, two.x);
}

TEST(IncompleteCholesky, IsExactWithoutFill) {
  const SparseMatrix a = dense({{2, -1, 0, 0}, {-1, 2, -1, 0}, {0, -1, 2, -1}, {0, 0, -1, 2}});
  const IncompleteCholesky m(a);
  EXPECT_EQ(m.shift(), 0);
  const CgOutcome run = preconditioned_cg(a, m, {1, 2, 3, 4}, {.relative_residual = 1e-14});
  EXPECT_EQ(run.iterations, 1U);
}

// Positive definite, but a pivot of the incomplete factors is negative (Kershaw 1978).
TEST(IncompleteCholesky, ShiftsWhereItBreaksDown) {
  const SparseMatrix a = dense({{3, -2, 0, 2}, {-2, 3, -2, 0}, {0, -2, 3, -2}, {2, 0, -2, 3}});
  EXPECT_NO_THROW(SparseLdlt{a});
  const IncompleteCholesky m(a);
  EXPECT_GT(m.shift(), 0);
  EXPECT_EQ(preconditioned_cg(a, m, {1, 2, 3, 4}, {.relative_residual = 1e-12}).status,
            IterationStatus::converged);
}

TEST(IterativeSolvers, RefuseWhatTheyCannotSolve) {
  const StopRule rule;
  const SparseMatrix indefinite = dense({{1, 2}, {2, 1}}), fine = dense({{2, 1}, {1, 2}});
  EXPECT_EQ(preconditioned_cg(indefinite, NoPreconditioner(indefinite), {1, -1}, rule).status,
            IterationStatus::indefinite);
  EXPECT_EQ(steepest_descent(indefinite, {1, -1}, rule).status, IterationStatus::indefinite);
  EXPECT_EQ(gauss_seidel(indefinite, {1, -1}, rule).status, IterationStatus::diverged);
  EXPECT_EQ(gauss_seidel(fine, {1, NAN}, rule).status, IterationStatus::non_finite);
  EXPECT_EQ(preconditioned_cg(fine, NoPreconditioner(fine), {1, INFINITY}, rule).status,
            IterationStatus::non_finite);
  const SparseMatrix broken = dense({{2, NAN}, {NAN, 2}});
  EXPECT_EQ(preconditioned_cg(broken, NoPreconditioner(broken), {1, 1}, rule).status,
            IterationStatus::non_finite);
  EXPECT_THROW(IncompleteCholesky{broken}, std::invalid_argument);
  const SparseMatrix hollow = dense({{0, 1}, {1, 0}});
  EXPECT_THROW(JacobiPreconditioner{hollow}, std::invalid_argument);
  EXPECT_THROW(SsorPreconditioner{hollow}, std::invalid_argument);
  EXPECT_THROW(IncompleteCholesky{hollow}, std::invalid_argument);
  EXPECT_THROW(gauss_seidel(hollow, {1, 1}, rule), std::invalid_argument);
  EXPECT_THROW((SsorPreconditioner{fine, 2}), std::invalid_argument);
  EXPECT_THROW(SparseLdlt{indefinite}, std::invalid_argument);
  EXPECT_THROW(SparseLdlt{dense({{1, -1}, {-1, 1}})}, std::invalid_argument);
}

}  // namespace
}  // namespace odeum::linear::iterative_solvers_test
