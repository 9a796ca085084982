// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/reduction/reduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace odeum::study::reduction_test {
namespace {

const ReductionRow& row_at(const std::vector<ReductionRow>& rows, const std::string& solver,
                           double lambda) {
  for (const ReductionRow& row : rows)
    if (row.solver == solver && std::abs(row.lambda / lambda - 1) < 1e-9) return row;
  throw std::runtime_error("no row of " + solver);
}

// Hairer and Wanner, Solving ODEs II, IV.15, table 15.1: the order where h |lambda| is large.
TEST(Reduction, IsToTheOrderOfTheStages) {
  const auto rows =
      measure_reduction(
          {.solvers = {"odeum/gauss4", "odeum/gauss6", "odeum/radau_iia5", "odeum/sdirk4",
                       "odeum/lobatto_iiic4", "odeum/bdf4", "odeum/implicit_midpoint"}})
          .rows;
  EXPECT_EQ(rows.size(), 7U * 9);
  struct Expected {
    const char* solver;
    double lambda, order;
  };
  // Gauss: s for an even number of stages, s + 1 for an odd one. Radau IIA: s, Lobatto IIIC: s - 1,
  // diagonally implicit: 1, all three divided by lambda.
  for (const auto& [solver, lambda, order] :
       {Expected{"gauss4", -1e8, 2}, Expected{"gauss6", -1e8, 4}, Expected{"radau_iia5", -1e4, 3},
        Expected{"lobatto_iiic4", -1e6, 2}, Expected{"sdirk4", -1e6, 1},
        Expected{"implicit_midpoint", -1e8, 2}, Expected{"bdf4", -1e4, 4}})
    EXPECT_NEAR(row_at(rows, solver, lambda).fit.order, order, 0.15) << solver;
  for (const auto& [solver, order] : {std::pair{"gauss4", 4}, std::pair{"sdirk4", 4},
                                      std::pair{"lobatto_iiic4", 4}, std::pair{"bdf4", 4}})
    EXPECT_NEAR(row_at(rows, solver, -1).fit.order, order, 0.15) << solver << ", not stiff";
  EXPECT_EQ(row_at(rows, "sdirk4", -1e6).fit.verdict, judge::Verdict::lower);
  EXPECT_NEAR(std::log10(row_at(rows, "sdirk4", -1e6).error_finest /
                         row_at(rows, "sdirk4", -1e7).error_finest),
              1, 0.1);
}

TEST(Reduction, SaysWhyThereIsNoOrder) {
  const auto rows = measure_reduction({.solvers = {"odeum/rk4", "odeum/leapfrog"}}).rows;
  EXPECT_EQ(row_at(rows, "rk4", -1).fit.verdict, judge::Verdict::confirmed);
  const ReductionRow& stiff = row_at(rows, "rk4", -1e8);
  EXPECT_EQ(stiff.fit.verdict, judge::Verdict::undetermined) << "a few steps end, at 1e40 and more";
  EXPECT_NE(stiff.fit.reason.find("non_finite"), std::string::npos) << stiff.fit.reason;
  EXPECT_TRUE(std::isnan(stiff.error_finest));
  EXPECT_EQ(row_at(rows, "leapfrog", -1).fit.verdict, judge::Verdict::not_applicable);
  EXPECT_NE(row_at(rows, "leapfrog", -1).fit.reason, "");
}

}  // namespace
}  // namespace odeum::study::reduction_test
