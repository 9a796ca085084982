// SPDX-License-Identifier: BSD-3-Clause
// The decomposition of an error on schemes with known parts; and its files.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "odeum/studies/cloth/cloth.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::study::cloth_test {
namespace {

// Two particles; each part of the error moves the second along an axis of its own. RMS over two.
constexpr double model = 0.3, by_step = 5, by_iteration = 0.8;
const std::vector<double> truth{0, 0, 0, 1, 2, 3};

SplitPlan plan_of(double order) {
  SplitPlan plan;
  plan.steps = {10, 20, 40, 80};
  plan.tried = {{.sweeps = 1}, {.sweeps = 4}};
  plan.converged = {.sweeps = 1024};
  plan.half = {.sweeps = 512};
  plan.order = order;
  return plan;
}

RunCloth scheme(double order) {
  return [order](std::uint64_t steps, const Iterations& n) -> Reached {
    const double h = 0.25 / static_cast<double>(steps);
    std::vector<double> x = truth;
    x[3] += model;
    x[4] += by_step * std::pow(h, order);
    if (n.sweeps > 0) x[5] += by_iteration / std::pow(4.0, static_cast<double>(n.sweeps));
    return {std::move(x), {}};
  };
}

TEST(ErrorParts, AreThoseOfAKnownScheme) {
  const double rms = 1 / std::sqrt(2.0), rounding = 1e-14;
  for (const double order : {1.0, 2.0}) {
    const auto rows = split_error(plan_of(order), scheme(order), truth);
    ASSERT_EQ(rows.size(), 8U);
    for (const ErrorPartsRow& row : rows) {
      const double step = by_step * std::pow(row.step, order),
                   iteration = by_iteration / std::pow(4.0, static_cast<double>(row.sweeps));
      EXPECT_EQ(row.status, "ok");
      EXPECT_NEAR(row.iteration, rms * iteration, rounding);
      EXPECT_NEAR(row.time_step, rms * step, rounding);
      EXPECT_NEAR(row.model, rms * model, rounding);
      EXPECT_NEAR(row.total, rms * std::hypot(model, step, iteration), rounding);
      EXPECT_NEAR(row.step_left, 0, rounding);
      EXPECT_NEAR(row.iteration_left, 0, rounding);
    }
  }
}

TEST(ErrorParts, TellHowFarALimitIsOff) {
  // Extrapolated as of order 1, a scheme of order 2 does not reach its limit.
  for (const ErrorPartsRow& row : split_error(plan_of(1), scheme(2), truth)) {
    EXPECT_GT(row.step_left, 1e-6);
    // At N/2, N, 2N the extrapolations miss by -2 and -1/2 of the finest error.
    const double finest = by_step * std::pow(0.25 / 80, 2) / std::sqrt(2.0);
    EXPECT_NEAR(row.step_left, 6 * finest, 1e-12);
  }
}

TEST(ErrorParts, HaveNoIterationsWhereNoneAreCounted) {
  SplitPlan plan = plan_of(1);
  plan.tried = {{}};
  plan.converged = plan.half = {};
  int runs = 0;
  const RunCloth counted = [&](std::uint64_t steps, const Iterations& n) {
    ++runs;
    return scheme(1)(steps, n);
  };
  for (const ErrorPartsRow& row : split_error(plan, counted, truth)) EXPECT_EQ(row.iteration, 0);
  EXPECT_EQ(runs, 4) << "one for each number of steps";
}

TEST(ErrorParts, SayWhereARunFailed) {
  const RunCloth coarse_fails = [](std::uint64_t steps, const Iterations& n) {
    return steps == 10 ? Reached{{}, "blew up"} : scheme(1)(steps, n);
  };
  const auto rows = split_error(plan_of(1), coarse_fails, truth);
  EXPECT_EQ(rows[0].status, "unstable");
  EXPECT_EQ(rows[0].detail, "blew up");
  EXPECT_TRUE(std::isnan(rows[0].total));
  EXPECT_NEAR(rows[2].model, model / std::sqrt(2.0), 1e-14) << "its limit needs the finest three";
  const RunCloth fine_fails = [](std::uint64_t steps, const Iterations& n) {
    return steps == 80 ? Reached{{}, "blew up"} : scheme(1)(steps, n);
  };
  const auto limitless = split_error(plan_of(1), fine_fails, truth);
  EXPECT_EQ(limitless[0].status, "ok");
  EXPECT_NE(limitless[0].detail.find("no limit"), std::string::npos);
  EXPECT_TRUE(std::isnan(limitless[0].model));
}

TEST(LongRun, VerletKeepsMomentumAndRungeKuttaDoesNot) {
  const auto rows =
      measure_long_runs({.solvers = {"odeum/velocity_verlet", "odeum/rk4"}}, Runner(2)).long_run;
  double verlet = 0, rk4 = 0, linear = 0, drape = 0, energy = 0, exact = 0;
  for (const LongRunRow& row : rows) {
    EXPECT_EQ(row.status, "ok") << row.detail;
    if (row.quantity == "linear_momentum") linear = std::max(linear, row.value);
    if (row.quantity == "angular_momentum")
      (row.solver == "rk4" ? rk4 : verlet) =
          std::max(row.solver == "rk4" ? rk4 : verlet, row.value);
    if (row.solver != "velocity_verlet" || row.setting > 0.01 || row.time != 10) continue;
    if (row.quantity == "drape") drape = row.value;
    if (row.quantity == "energy") energy = row.value, exact = row.reference;
  }
  // 2,400 steps of sums over 121 particles, each rounded by 1e-16.
  EXPECT_LT(linear, 1e-12);
  EXPECT_LT(verlet, 1e-12);
  EXPECT_GT(rk4, 1e-6) << "or the quantity would see nothing";
  // At rest by then: the remaining motion has an effect of second order.
  EXPECT_GT(drape, 0);
  EXPECT_LT(drape, 1e-3);
  EXPECT_NEAR(energy, exact, 1e-3);
}

}  // namespace
}  // namespace odeum::study::cloth_test
