// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "odeum/studies/precision/precision.hpp"

namespace odeum::study::precision_outputs_test {
namespace {

// Own methods, CVODE, ARKODE and odeint have states between their steps, GSL ends them on outputs.
TEST(Precision, HasOutputsBetweenStepsAndAtTheirEnds) {
  const PrecisionResult result = measure_precision(
      {.cases = {"damped_oscillator_underdamped"},
       .solvers = {"odeum/dormand_prince54", "cvode/adams", "arkode/erkstep_dormand_prince_7_4_5",
                   "odeint/runge_kutta_dopri5", "odeint/rosenbrock4", "gsl/rk8pd"},
       .own = {{"seconds", "0.01"}, {"attempts", "1"}}});
  ASSERT_EQ(result.outputs.size(), 6U);
  for (const OutputRow& row : result.outputs) {
    const std::string id = row.library + "/" + row.solver;
    EXPECT_EQ(row.status, "ok") << id << ": " << row.detail;
    EXPECT_GE(row.outputs, 100U);
    // The oscillator is known at all times: an error at an output, not at the end alone.
    EXPECT_GT(row.error_between, 0) << id;
    EXPECT_LT(row.error_between, 1e-4) << id;
    EXPECT_LT(row.error_ends, 1e-4) << id;
    if (row.library == "gsl") {
      EXPECT_EQ(row.steps_ends, row.steps_between) << id;
    } else if (row.library != "cvode") {  // which interpolates in any case
      EXPECT_LT(row.steps_between, row.steps_ends) << id;
      EXPECT_LT(row.work_between, row.work_ends) << id;
    }
  }
}

}  // namespace
}  // namespace odeum::study::precision_outputs_test
