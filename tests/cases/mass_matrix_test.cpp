// SPDX-License-Identifier: BSD-3-Clause
// The energy of two masses does not depend on the coordinates that describe them.
#include <gtest/gtest.h>

#include "support/catalogue.hpp"

namespace odeum::tests::mass_matrix_test {
namespace {

TEST(MassMatrix, EnergyIsTheSameInBothCoordinates) {
  const Case& usual = find_case("mass_matrix");
  // m1, m2, k1, k2, k12 and the start in s = x1 + x2, d = x1 - x2 and their rates.
  for (const std::vector<double>& p : {std::vector<double>{1, 3, 4, 5, 2, 1, 0.5, 0, -0.3},
                                       {2, 2, 4, 5, 2, 1, 0.5, 0.7, -0.3},
                                       {0.5, 7, 1, 9, 30, -1, 2, 3, 4}}) {
    const Case c = usual.with_values(p, {});
    for (const double t : {0.7, 3.1}) {
      double y[4];
      ASSERT_TRUE(c.truth.at(t, y));
      const double x1 = (y[0] + y[1]) / 2, x2 = (y[0] - y[1]) / 2;
      const double v1 = (y[2] + y[3]) / 2, v2 = (y[2] - y[3]) / 2;
      const double energy = (p[0] * v1 * v1 + p[1] * v2 * v2) / 2 +
                            (p[2] * x1 * x1 + p[3] * x2 * x2 + p[4] * (x1 - x2) * (x1 - x2)) / 2;
      // A dozen roundings.
      EXPECT_NEAR(c.energy(y) / energy, 1, 1e-14) << t;
      EXPECT_NEAR(c.energy(y) / c.energy(c.y0.data()), 1, 1e-12) << t;
    }
  }
}

}  // namespace
}  // namespace odeum::tests::mass_matrix_test
