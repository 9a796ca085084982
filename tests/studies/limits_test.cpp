// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/limits/limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/spectrum.hpp"
#include "odeum/studies/stability/stability.hpp"
#include "support/catalogue.hpp"

namespace odeum::study::limits_test {
namespace {

TEST(FewestBoundedSteps, AreBisected) {
  const auto from = [](std::uint64_t least) {
    return fewest_bounded_steps([=](std::uint64_t steps) { return steps >= least; }, 1 << 17);
  };
  EXPECT_EQ(from(1), 4U);
  EXPECT_EQ(from(5), 8U);
  EXPECT_EQ(from(37), 40U) << "the next multiple of 4";
  EXPECT_GE(from(10'000), 10'000U);
  EXPECT_LE(from(10'000), 10'000U + 16'384 / 256);
  EXPECT_EQ(from(1 << 20), 0U);
}

TEST(FewestBoundedSteps, AreNotFooledByOneLuckyRun) {
  EXPECT_EQ(fewest_bounded_steps([](std::uint64_t steps) { return steps == 16 || steps >= 100; },
                                 1 << 17),
            100U);
}

TEST(Spectrum, IsThatOfTheStiffChain) {
  const Case& c = tests::find_case("stiff_chain2_k1e4");
  // q'' = -K q with the eigenvalues w^2 = (20001 +- sqrt(20001^2 - 4e4)) / 2 of K: +- i w.
  const double root = std::sqrt(20001.0 * 20001 - 4e4);
  const double fast = std::sqrt((20001 + root) / 2), slow = std::sqrt(1e4) / fast;
  std::vector<double> frequencies;
  for (const auto& z : cases::outermost_eigenvalues(c, 0, c.y0)) {
    EXPECT_NEAR(z.real(), 0, 1e-10);
    frequencies.push_back(z.imag());
  }
  std::sort(frequencies.begin(), frequencies.end());
  ASSERT_EQ(frequencies.size(), 2U) << "one of each pair";
  const double expected[] = {slow, fast};
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(frequencies[i], expected[i], 1e-9);
}

const LargestStep& row_of(const std::vector<LargestStep>& rows, const std::string& solver) {
  for (const LargestStep& row : rows)
    if (row.solver == solver) return row;
  throw std::runtime_error("no row of " + solver);
}

TEST(Limits, OnStiffDecayAreWhereTheoryPutsThem) {
  for (const char* id : {"prothero_robinson_1e3_smooth", "vdp_mu1000"}) {
    const auto rows =
        measure_limits(
            {.cases = {id},
             .solvers = {"odeum/explicit_euler", "odeum/rk4", "odeum/dormand_prince54", "gsl/rkck",
                         "odeum/cash_karp54", "odeum/implicit_euler", "odeum/leapfrog"}})
            .rows;
    const double lambda = std::string(id) == "vdp_mu1000" ? 3000 : 1000;
    for (const auto& [solver, limit] : {std::pair{"explicit_euler", 2.0}, std::pair{"rk4", 2.785},
                                        std::pair{"dormand_prince54", 3.307}}) {
      const LargestStep& row = row_of(rows, solver);
      EXPECT_NEAR(row.eigenvalue.real(), -lambda, 1e-3 * lambda) << id;
      EXPECT_NEAR(row.predicted_step, limit / lambda, 1e-3 * limit / lambda) << id << solver;
      // Half a per cent from the bisection; what has grown tenfold grew faster than 1.
      EXPECT_NEAR(row.largest_stable_step, row.predicted_step, 0.01 * row.predicted_step)
          << id << solver << row.detail;
    }
    EXPECT_TRUE(std::isinf(row_of(rows, "implicit_euler").predicted_step));
    EXPECT_EQ(row_of(rows, "implicit_euler").largest_stable_step,
              row_of(rows, "implicit_euler").window / 4);
    EXPECT_EQ(row_of(rows, "leapfrog").status, "not_applicable");
    EXPECT_NE(row_of(rows, "leapfrog").detail, "");
  }
}

TEST(Limits, OfAPeerAreThoseOfTheSameTableau) {
  const auto rows = measure_limits({.cases = {"prothero_robinson_1e3_layer"},
                                    .solvers = {"gsl/rkck", "odeum/cash_karp54"}})
                        .rows;
  if (rows.size() < 2) GTEST_SKIP() << "built without GSL";
  EXPECT_NEAR(row_of(rows, "rkck").largest_stable_step,
              row_of(rows, "cash_karp54").largest_stable_step, 1e-5);
  EXPECT_TRUE(std::isnan(row_of(rows, "rkck").predicted_step)) << "no function is known";
}

TEST(Limits, OnAnOscillationFollowItsFrequency) {
  const auto rows =
      measure_limits({.cases = {"stiff_chain2_k1e4"}, .solvers = {"odeum/stormer_verlet"}}).rows;
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NEAR(rows[0].eigenvalue.imag(), 141.42, 0.01);
  EXPECT_NEAR(rows[0].predicted_step, 2 / 141.42, 1e-5);
  // 72 steps fill the window: one more or less is 1.4 %.
  EXPECT_NEAR(rows[0].largest_stable_step, rows[0].predicted_step, 0.06 * rows[0].predicted_step);
}

const StableStep& step_of(const StabilityResult& result, const std::string& solver) {
  for (const StableStep& row : result.steps)
    if (row.library + "/" + row.solver == solver) return row;
  throw std::out_of_range(solver);
}

// The Jacobian is -1000, and nothing else.
TEST(StabilityOfACase, IsThatOfItsEigenvalues) {
  const StabilityResult result = measure_stability(
      {.cases = {"prothero_robinson_1e3_smooth"},
       .solvers = {"odeum/explicit_euler", "odeum/rk4", "odeum/implicit_euler", "odeum/leapfrog",
                   "odeum/dormand_prince54", "odeum/gragg_bulirsch_stoer"}});
  EXPECT_TRUE(result.limits.empty());
  EXPECT_TRUE(result.regions.empty());
  // The limit is measured to 1e-6.
  EXPECT_NEAR(step_of(result, "odeum/explicit_euler").step, 2e-3, 3e-9);
  EXPECT_NEAR(step_of(result, "odeum/rk4").step, 2.785293563405e-3, 3e-9);
  EXPECT_TRUE(std::isinf(step_of(result, "odeum/implicit_euler").step));
  EXPECT_NEAR(step_of(result, "odeum/rk4").eigenvalue.real(), -1000, 1e-9);
  EXPECT_EQ(step_of(result, "odeum/leapfrog").status, "not_applicable");
}

// +- 141 i and +- 0.7 i: the slow pair limits nothing.
TEST(StabilityOfACase, IsLimitedByTheFastPair) {
  const StabilityResult result =
      measure_stability({.cases = {"stiff_chain2_k1e4"}, .solvers = {"odeum/rk4", "odeum/heun"}});
  // sqrt(8) on the imaginary axis; Heun's method grows everywhere on it.
  EXPECT_NEAR(step_of(result, "odeum/rk4").step, std::sqrt(8) / 141.42, 1e-5);
  EXPECT_EQ(step_of(result, "odeum/heun").step, 0);
}

// 726 unknowns: the fastest vibration by Arnoldi's method, and the steps that it allows.
TEST(StabilityOfACase, IsKnownForALargeSystem) {
  const StabilityResult result = measure_stability(
      {.cases = {"cloth11_two_way_k1e3"},
       .solvers = {"odeum/rk4", "odeum/velocity_verlet", "odeum/implicit_euler"}});
  const StableStep& rk4 = step_of(result, "odeum/rk4");
  ASSERT_EQ(rk4.status, "ok") << rk4.detail;
  // Lightly damped: the limit is near that of the imaginary axis.
  EXPECT_NEAR(rk4.step * std::abs(rk4.eigenvalue), std::sqrt(8), 0.15);
  const StableStep& verlet = step_of(result, "odeum/velocity_verlet");
  ASSERT_EQ(verlet.status, "ok") << verlet.detail;
  EXPECT_NEAR(verlet.step * std::abs(verlet.eigenvalue), 2, 0.1);
  EXPECT_TRUE(std::isinf(step_of(result, "odeum/implicit_euler").step));
}

}  // namespace
}  // namespace odeum::study::limits_test
