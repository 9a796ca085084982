// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "odeum/studies/evolution/rows.hpp"
#include "support/report_fixture.hpp"

namespace odeum::study::evolution_test {
namespace {

const EvolutionResult& result() {
  static const EvolutionResult all = measure_evolution({.own = {{"most", "32"}}}, Runner(2));
  return all;
}

TEST(Evolution, OrdersInTimeAndInSpaceAreConfirmed) {
  for (const EvolutionOrderRow& row : result().orders)
    EXPECT_EQ(row.fit.verdict, judge::Verdict::confirmed)
        << row.problem << ' ' << row.solver << ' ' << row.direction << ": " << row.fit.order << ' '
        << row.fit.reason;
  EXPECT_EQ(result().orders.size(), 16U);  // nine in time, and in space but for order 1
}

// The whole error is at most the sum of its parts, and at least their difference.
TEST(Evolution, ErrorsOfMeshAndStepsAddUp) {
  for (const EvolutionRow& row : result().runs) {
    ASSERT_EQ(row.status, "ok") << row.solver << row.detail;
    // Rounding, where the solution and its error are of size 1.
    EXPECT_LE(row.error, row.error_space + row.error_time + 1e-12);
    EXPECT_GE(row.error, std::abs(row.error_space - row.error_time) - 1e-12);
  }
}

TEST(Evolution, CheapestPairsHaveTheLeastWork) {
  std::size_t reached = 0;
  for (const EvolutionCheapestRow& best : result().cheapest) {
    double least = INFINITY;
    for (const EvolutionRow& row : result().runs)
      if (row.problem == best.problem && row.solver == best.solver && row.error <= best.target)
        least = std::min(least, row.work);
    EXPECT_EQ(best.status == "ok", std::isfinite(least));
    if (best.status != "ok") continue;
    ++reached;
    EXPECT_EQ(best.work, least);
    EXPECT_LE(best.error, best.target);
  }
  EXPECT_GE(reached, 9U);  // 1e-2 by every solver
}

// The work of explicit solvers is their products: entries of K times evaluations. With d divisions
// K has 5 (d - 1)^2 - 4 (d - 1) entries, and those along the diagonals of the squares, which are 0.
TEST(Evolution, WorkIsCounted) {
  std::size_t seen = 0;
  for (const EvolutionRow& row : result().runs) {
    if (row.solver != "odeum/explicit_euler") continue;
    ++seen;
    const auto n = static_cast<double>(row.divisions) - 1;
    const double entries = 5 * n * n - 4 * n + 2 * (n - 1) * (n - 1);
    // One evaluation a step, and one or none more.
    const auto steps = static_cast<double>(row.steps);
    EXPECT_GE(row.work, entries * steps);
    EXPECT_LE(row.work, entries * (steps + 1));
  }
  EXPECT_GE(seen, 4U);
}

TEST(Evolution, ModesAndLimitsAreThoseOfTheory) {
  const EvolutionResult modes = measure_modes();
  EXPECT_EQ(modes.modes.size(), 16U);
  for (const EvolutionModeRow& row : modes.modes) {
    // Rounding of states of size 1, against a coordinate of 1e-3 or more.
    EXPECT_NEAR(row.measured, row.predicted, 1e-11) << row.solver << row.waves;
    if (row.solver == "odeum/trapezoidal" && row.quantity == "factor") {
      EXPECT_GT(row.measured, 0.5);
    }
  }
  EXPECT_EQ(modes.limits.size(), 4U);
  for (const EvolutionLimitRow& row : modes.limits)
    // Growth is seen from 0.2 % beyond the limit on, see 2000 steps of |R| = 1.004.
    EXPECT_NEAR(row.measured / row.predicted, 1, 4e-3) << row.problem << row.mass;
}

TEST(Evolution, HandsItsRowsToAReport) {
  test::Report report{report::Facts()};
  for (const auto& study : make_studies()) {
    if (study->declaration().name != "evolution") continue;
    study->measure({.own = {{"most", "16"}}}, Runner(2));
    report.report().study(study->facts());
    study->show(report.report());
  }
  const auto studies = report.write().json("page.json")["studies"];
  ASSERT_EQ(studies.size(), 1U);
  EXPECT_EQ(studies[0]["name"], "evolution");
  for (const char* file : {"evolution", "evolution_orders", "evolution_cheapest"})
    EXPECT_GT(report.table(file)["rows"], 0) << file;
}

}  // namespace
}  // namespace odeum::study::evolution_test
