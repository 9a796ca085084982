// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "odeum/studies/mesh/rows.hpp"

namespace odeum::study::mesh_test {
namespace {

const std::vector<MeshRow>& rows() {
  static const std::vector<MeshRow> measured =
      measure_mesh({.own = {{"most", "12"}}}, Runner(2)).rows;
  return measured;
}

// Structural springs hang as n columns of n particles side by side: the spring below row i carries
// i particles, and the slowest mode of N = n - 1 masses is known in closed form.
TEST(Mesh, StructuralSpringsAreColumnsSideBySide) {
  int seen = 0;
  for (const MeshRow& row : rows()) {
    EXPECT_EQ(row.status, "ok") << row.detail;
    EXPECT_EQ(std::isnan(row.drape), row.springs == "structural");
    if (row.springs != "structural") continue;
    ++seen;
    const auto n = static_cast<double>(row.particles);
    const double extension = 9.81 * (n - 1) / (2 * row.stiffness * n);
    // Relaxation ends at 1e-5 of gravity, which is 1e-5 of the extension in the slowest mode.
    EXPECT_NEAR(row.extension / extension, 1, 1e-4) << row.scaling << n;
    const double frequency =
        2 * std::sqrt(row.stiffness * n * n) * std::sin(std::numbers::pi / (2 * (2 * (n - 1) + 1)));
    // Let go from a parabola, not from the mode's own shape: the third mode has a thirtieth of the
    // first one's amplitude, which moves a crossing by a hundredth of a period, over four periods.
    EXPECT_NEAR(row.period * frequency / (2 * std::numbers::pi), 1, 5e-3) << row.scaling << n;
  }
  EXPECT_EQ(seen, 3 * 2);
}

TEST(Mesh, AFinerSheetNeedsTheFactorThatItsScalingLacks) {
  for (const MeshRow& row : rows()) {
    if (row.particles != 12) continue;
    const double lacks = row.scaling == "constant"     ? 1
                         : row.scaling == "per_length" ? 5. / 11
                                                       : 11. / 5;
    if (row.springs == "structural") {
      // Equal masses: of n rows, n - 1 hang.
      EXPECT_NEAR(row.factor, lacks * (11. / 12) / (5. / 6), 2e-4) << row.scaling;
    } else {
      // Edges have fewer diagonal and long springs, and weigh less at a finer mesh.
      EXPECT_NEAR(row.factor / lacks, 1, 0.2) << row.springs << ' ' << row.scaling;
    }
    EXPECT_GT(row.sag, 0);
    if (row.springs != "structural") {
      EXPECT_GT(row.drape, 1);
    }
  }
}

}  // namespace
}  // namespace odeum::study::mesh_test
