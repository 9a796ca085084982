// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/cost/cost.hpp"

#include <gtest/gtest.h>

namespace odeum::study::cost_test {
namespace {

TEST(ClothSpeed, TimesEverySizeInBothPrecisions) {
  const auto rows = measure_cloth_cost({5, 11}, 1e-3);
  ASSERT_EQ(rows.size(), 4U);
  for (const ClothCostRow& row : rows) {
    EXPECT_GT(row.wall_ns_min, 0);
    EXPECT_GE(row.wall_ns_median, row.wall_ns_min);
    EXPECT_GE(row.repetitions, 3U);
  }
  EXPECT_EQ(rows[0].precision, "f64");
  EXPECT_EQ(rows[3].precision, "f32");
}

TEST(ClothSpeed, ExplicitEnginesAreStableAtTheirSteps) {
  const auto rows = measure_implicit_wins(11, {10, 1e4}, {1.0 / 120, 1.0 / 30}, 1e-3);
  ASSERT_EQ(rows.size(), 2U * 4);
  for (const ImplicitWinsRow& row : rows) {
    EXPECT_EQ(row.status, "ok") << row.engine << row.stiffness << row.detail;
    EXPECT_GT(row.wall_ns_min, 0);
    // Order 2 at a large but stable step; beyond it errors have no bound.
    if (row.engine != "implicit_f64") {
      EXPECT_LT(row.rk4_distance, 0.02) << row.engine << row.stiffness;
    }
    EXPECT_LT(row.rk4_left, 1e-3);
  }
  EXPECT_GT(rows[3].rk4_distance, rows[2].rk4_distance)
      << "implicit, order 1, at four times the step";
}

}  // namespace
}  // namespace odeum::study::cost_test
