// SPDX-License-Identifier: BSD-3-Clause
// The integrator that an FMU brings, as a solver: that of the test's FMU is the midpoint rule.
#include "fmi_stage.hpp"
#include "support/catalogue.hpp"

namespace odeum::co_simulation_test {
namespace {

class CoSimulation : public fmi_tests::Fmus {
 protected:
  Case both(const fmi_tests::Values& values = {}) {
    foreign::ProblemCallbacks given =
        open_fmu(fmu([](std::string& xml) {
                   fmi_tests::replace(xml, "  <DefaultExperiment",
                                      "  <CoSimulation modelIdentifier=\"oscillator\"/>\n  "
                                      "<DefaultExperiment");
                 }),
                 values);
    given.id = "model";
    return case_before_truth(cases::foreign_statement(std::move(given)));
  }
  static Outcome run(const Case& c, const std::string& solver, std::uint64_t steps) {
    return tests::find_entrant(c, solver).solve(tests::fixed_request(steps, {4, 8}));
  }
};

TEST_P(CoSimulation, TakesTheStepsOfItsMethod) {
  const Case c = both({{"a", "0.5"}});
  for (const std::uint64_t steps : {64, 128}) {
    const Outcome own = run(c, "fmu/co_simulation", steps), same = run(c, "odeum/midpoint", steps);
    ASSERT_EQ(own.status, Status::ok) << own.detail;
    ASSERT_EQ(own.states.size(), same.states.size());
    EXPECT_EQ(own.counters.steps, steps);
    // The same operations but for the rounding of times.
    for (std::size_t i = 0; i < own.states.size(); ++i)
      EXPECT_NEAR(own.states[i], same.states[i], 1e-12) << i;
  }
}

TEST_P(CoSimulation, IsThereWhereTheFmuHasIt) {
  EXPECT_EQ(made().entrants.find("fmu/co_simulation"), nullptr);
  EXPECT_NE(both().entrants.find("fmu/co_simulation"), nullptr);
}

TEST_P(CoSimulation, WhatFailsIsAStatusWithItsReason) {
  const Outcome failed = run(both({{"fault", "10"}}), "fmu/co_simulation", 64);
  EXPECT_EQ(failed.status, Status::refused);
  EXPECT_NE(failed.detail.find("DoStep returned error at t = "), std::string::npos)
      << failed.detail;
  EXPECT_EQ(run(both({{"fault", "3"}}), "fmu/co_simulation", 64).status, Status::refused);
  const Outcome adaptive =
      tests::find_entrant(both(), "fmu/co_simulation").solve(tests::adaptive_request(1e-6, {8}));
  EXPECT_EQ(adaptive.status, Status::refused);
  EXPECT_NE(adaptive.detail.find("fixed step"), std::string::npos) << adaptive.detail;
}

INSTANTIATE_TEST_SUITE_P(Versions, CoSimulation, testing::Values(2, 3));

}  // namespace
}  // namespace odeum::co_simulation_test
