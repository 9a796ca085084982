// SPDX-License-Identifier: BSD-3-Clause
// What follows from a sparsity: differenced entries, the dense form, and runs of every solver on a
// problem that states its sparsity against the same problem without it.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/set_problem.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/linear/sparse_system.hpp"
#include "odeum/problem/difference_jacobian.hpp"

namespace odeum::tests::sparse_runs_test {
namespace {

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
  EXPECT_EQ(guard.jacobian_evaluations(), 1U);
  // y_0 = 0 is moved by 1.5e-11, in which the rounding of f, 200 times 2e-16, is 3e-3.
  for (std::size_t k = 0; k < exact.size(); ++k) EXPECT_NEAR(values[k], exact[k], 1e-2) << k;
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
  cases::set_problem(c, P{});
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
}  // namespace odeum::tests::sparse_runs_test
