// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "odeum/linear/linear_peer.hpp"
#include "odeum/studies/elements/problems.hpp"
#include "odeum/studies/elements/rows.hpp"
#include "support/report_fixture.hpp"

namespace odeum::study::elements_test {
namespace {

using std::numbers::pi;

// Four meshes of spacings that are halved are what a verdict needs at least; with 64 there are
// five.
ElementsResult orders() { return measure_orders(64, Runner(2)); }
ElementsResult solvers() { return measure_solvers(32, Runner(2)); }

// The truth of the study's own case: the series of sines, to terms below 1e-13.
TEST(Elements, CentreOfTheUnitLoadIsThatOfTheSeries) {
  double sum = 0;
  for (int j = 1; j < 40; j += 2) {
    const double sign = j % 4 == 1 ? 1 : -1;
    sum += sign / (std::pow(j, 3) * std::cosh(j * pi / 2));
  }
  const double centre = 1. / 8 - 4 / std::pow(pi, 3) * sum;
  for (const ModelProblem& model : model_problems())
    if (model.id == "poisson_square_unit_load") {
      EXPECT_NEAR(model.centre_value, centre, 1e-14);
    }
}

// Gradient and load are typed in: differences of the value tell whether they are its own.
TEST(Elements, ModelProblemsAreSolvedByTheirSolutions) {
  constexpr double h = 1e-4;
  for (const ModelProblem& model : model_problems()) {
    if (!model.value) continue;
    const auto flux = [&](double x, double y) {
      const fem::Tensor a =
          model.problem.diffusion ? model.problem.diffusion({x, y}) : fem::Tensor{};
      const fem::Point g = model.gradient({x, y});
      return fem::Point{a.xx * g.x + a.xy * g.y, a.xy * g.x + a.yy * g.y};
    };
    for (const auto& [x, y] : {std::pair{0.3, 0.4}, {-0.4, -0.3}, {-0.2, 0.6}}) {
      const fem::Point gradient = model.gradient({x, y});
      // Second differences leave h^2 / 6 times a third derivative, below 2000 here.
      EXPECT_NEAR((model.value({x + h, y}) - model.value({x - h, y})) / (2 * h), gradient.x, 1e-5);
      EXPECT_NEAR((model.value({x, y + h}) - model.value({x, y - h})) / (2 * h), gradient.y, 1e-5);
      const double divergence = (flux(x + h, y).x - flux(x - h, y).x) / (2 * h) +
                                (flux(x, y + h).y - flux(x, y - h).y) / (2 * h);
      EXPECT_NEAR(-divergence, model.problem.load({x, y}), 1e-4) << model.id;
    }
  }
}

TEST(Elements, HaveTheOrdersOfTheory) {
  std::size_t floors = 0;
  const ElementsResult result = orders();
  for (const ElementsOrderRow& row : result.orders) {
    const bool fixed = row.problem == "poisson_disc_fixed_polygon";
    EXPECT_EQ(row.fit.verdict, fixed ? judge::Verdict::floors : judge::Verdict::confirmed)
        << row.problem << ' ' << row.rule << ' ' << row.norm << ": " << row.fit.order << ' '
        << row.fit.reason;
    floors += fixed;
    // The corner's orders are not those of smooth solutions.
    if (row.problem == "poisson_l_shape" && row.norm == "h1") {
      EXPECT_LT(row.fit.high, 0.8);
    }
    EXPECT_NE(row.theory, "");
  }
  EXPECT_EQ(floors, 3U);
  EXPECT_EQ(result.orders.size(), 8 * 3 + 1U);
}

// Rules of quadrature for the load differ in the error's size.
TEST(Elements, RulesOfTheLoadAreToldApart) {
  std::vector<double> errors;
  const ElementsResult result = orders();
  for (const ElementsOrderRow& row : result.orders)
    if (row.problem == "poisson_square_smooth" && row.norm == "l2") errors.push_back(row.finest);
  ASSERT_EQ(errors.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_GT(std::abs(errors[i] / errors[(i + 1) % 3] - 1), 0.05) << i;
}

TEST(Elements, SolversKeepWithinTheirBounds) {
  std::size_t diverged = 0;
  const ElementsResult result = solvers();
  for (const ElementsSolverRow& row : result.solvers) {
    const bool skewed_jacobi =
        row.problem == "poisson_square_skewed" && row.solver == "odeum/jacobi";
    EXPECT_EQ(row.status, skewed_jacobi ? "diverged" : "ok") << row.solver << row.detail;
    if (skewed_jacobi) {
      ++diverged;
      EXPECT_GT(row.spectral_radius, 1);
      EXPECT_NE(row.detail.find("spectral radius"), std::string::npos);
      continue;
    }
    if (!std::isnan(row.iterations_bound)) {
      const auto iterations = static_cast<double>(row.iterations);
      EXPECT_LE(iterations, row.iterations_bound) << row.solver;
      EXPECT_GT(3 * iterations, row.iterations_bound) << row.solver << ": the bound says nothing";
    }
    // Jacobi's rate is its spectral radius, cos(pi / n).
    if (row.problem == "poisson_square_smooth" && row.solver == "odeum/jacobi") {
      const double radius = std::cos(pi / static_cast<double>(row.divisions));
      EXPECT_NEAR(row.spectral_radius, radius, 1e-6);
      EXPECT_NEAR(row.rate, radius, 1e-3);
      // D = 4 I: the condition number is that of A.
      EXPECT_NEAR(row.condition, (1 + radius) / (1 - radius), 1e-2 * row.condition);
    }
    if (row.problem == "poisson_square_smooth" && row.solver == "odeum/pcg_multigrid") {
      EXPECT_LE(row.iterations, 10U);
    }
  }
  EXPECT_EQ(diverged, 1U);
}

// The error of the solver is orthogonal to that of the mesh in the energy norm (Galerkin), but for
// the quadrature of the load.
TEST(Elements, ErrorsOfSolverAndMeshAddBySquares) {
  std::size_t seen = 0;
  const ElementsResult result = solvers();
  for (const ElementsStoppingRow& row : result.stopping) {
    EXPECT_NEAR(std::hypot(row.algebraic, row.discretisation) / row.total, 1, 1e-3)
        << row.solver << row.tolerance;
    seen += row.algebraic > row.discretisation / 10;
  }
  EXPECT_GE(seen, 2U) << "solvers that stop too early are among them";
}

TEST(Elements, TimesAreOfSolvedSystems) {
  const std::vector<ElementsTimeRow> times = time_solvers(32);
  ASSERT_EQ(times.size(), 6 + linear::linear_peers().size());
  for (const ElementsTimeRow& row : times) {
    EXPECT_EQ(row.status, "ok") << row.solver;
    EXPECT_GT(row.solve_ns_min, 0) << row.solver;
  }
}

TEST(Elements, HaveATableAndRowsForAReport) {
  ElementsResult result = measure_elements({.own = {{"most", "16"}}}, Runner(2));
  const std::string table = record::tables_of(result);
  for (const char* title : {"elements_orders.csv", "elements_solvers.csv", "elements_stopping.csv",
                            "elements_times.csv"})
    EXPECT_NE(table.find(title), std::string::npos) << title;
  // Three problems at 8 divisions: squares of two triangles, on the L shape three of four parts of
  // 4; a hexagon of 6 in 64 each.
  ASSERT_EQ(result.fields.size(), 2U * 64 + 2 * 3 * 64 + 6 * 64);
  // A value that no solution has: pictures are made of the rows.
  result.fields.front().u[1] = 77.25;
  test::Report report{report::Facts()};
  report.add({.name = "elements", .command = "elements", .help = ""}, result).write();
  EXPECT_EQ(report.column("elements_fields", "u2").at(0), 77.25);
  for (const char* column : {"x1", "y3", "u1", "error3"})
    for (const auto& value : report.column("elements_fields", column))
      EXPECT_TRUE(value.is_number()) << column;
  EXPECT_EQ(report.table("elements_times")["rows"], result.times.size());
}

}  // namespace
}  // namespace odeum::study::elements_test
