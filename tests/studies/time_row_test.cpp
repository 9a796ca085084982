// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study::time_row_test {
namespace {

TEST(TimeRow, HasSixDigitsOfErrorsAndNineOfTheEnergy) {
  ConvergenceRow run;
  run.step = 0.1234567890123;
  const TimeRow row = time_row(run, {.time = 1.0 / 3,
                                     .error_max = 1.23456789e-7,
                                     .error_rms = std::nan(""),
                                     .energy = -1.23456789012,
                                     .energy_error = INFINITY});
  EXPECT_EQ(row.step, run.step);
  EXPECT_EQ(row.time, 1.0 / 3);
  EXPECT_EQ(row.error_max, 1.23457e-7);
  EXPECT_TRUE(std::isnan(row.error_rms));
  EXPECT_EQ(row.energy, -1.23456789);
  EXPECT_EQ(row.energy_error, INFINITY);
}

}  // namespace
}  // namespace odeum::study::time_row_test
