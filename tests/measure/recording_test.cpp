// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/measure/recording.hpp"

#include <gtest/gtest.h>

#include "odeum/measure/local.hpp"
#include "support/catalogue.hpp"

namespace odeum::recording_test {
namespace {

using tests::adaptive_request;
using tests::find_case;
using tests::state_at;

/// Own methods and peers of each library whose steps are told, where this build has it.
constexpr const char* recorded[] = {"odeum/dormand_prince54",
                                    "odeum/radau_iia5",
                                    "cvode/adams",
                                    "cvode/bdf",
                                    "arkode/erkstep_dormand_prince_7_4_5",
                                    "gsl/rkf45",
                                    "gsl/msbdf",
                                    "odeint/runge_kutta_dopri5",
                                    "odeint/dense_output_runge_kutta_dopri5",
                                    "odeint/rosenbrock4"};

TEST(Recording, TellsEveryStepAndChangesNone) {
  for (const char* name : {"lotka_volterra", "hires"}) {
    const Case& c = find_case(name);
    for (const char* id : recorded) {
      const Entrant* const entrant = c.entrants.find(id);
      if (!entrant || !entrant->unfit.empty()) continue;
      Request request = adaptive_request(1e-5, {c.t0 + 0.1 * (c.stops.back() - c.t0)});
      const Outcome plain = entrant->solve(request);
      request.record_steps = true;
      const Outcome told = entrant->solve(request);
      ASSERT_EQ(plain.status, Status::ok) << name << " " << id << " " << plain.detail;
      ASSERT_EQ(told.status, Status::ok) << name << " " << id << " " << told.detail;
      EXPECT_EQ(told.states, plain.states) << name << " " << id;
      EXPECT_EQ(told.counters.rhs_evaluations, plain.counters.rhs_evaluations) << name << " " << id;
      ASSERT_EQ(told.step_ends.size(), plain.counters.steps) << name << " " << id;
      EXPECT_EQ(told.step_ends.back(), request.stops.back()) << name << " " << id;
    }
  }
}

TEST(Recording, GivesTheStatesOfTheRunItself) {
  const Case& c = find_case("lotka_volterra");
  const Request request = adaptive_request(1e-5, {5});
  const measure::Run run = measure::record(c, "odeum/dormand_prince54", request, 1000);
  // With so many moments each step is one.
  ASSERT_EQ(run.moments.size(), run.steps() + 1);
  EXPECT_EQ(run.moments.back().y, run.outcome.states);
  EXPECT_EQ(run.trace.times.size(), run.outcome.counters.rhs_evaluations);
  for (std::size_t k = 0; k < run.steps(); ++k) {
    // A step of the method from one is the next: at a fixed step it takes no decision.
    const measure::Moment &at = run.moments[k], &next = run.moments[k + 1];
    const measure::Recording from(c, at.t, at.y);
    const Outcome one =
        from.solver("odeum/dormand_prince54")->solve(tests::fixed_request(1, {at.t + at.h}));
    for (std::size_t i = 0; i < at.y.size(); ++i)
      EXPECT_NEAR(one.states[i], next.y[i], 1e-13) << "step " << k;  // t + h is rounded
  }
}

// Known limits: 2.785 and 2.828 of classical Runge-Kutta, 2 of explicit Euler and of Verlet.
TEST(Region, HasTheKnownEdges) {
  EXPECT_NEAR(measure::Region("odeum/rk4").edge(-1), 2.785, 0.02);
  EXPECT_NEAR(measure::Region("odeum/rk4").edge({0, -50}), 2.828, 0.02);
  EXPECT_NEAR(measure::Region("odeum/explicit_euler").edge(-3), 2, 0.02);
  EXPECT_EQ(measure::Region("odeum/explicit_euler").edge({0, 1}), 0);
  EXPECT_NEAR(measure::Region("odeum/velocity_verlet").edge({1e-12, 1}), 2, 0.02);
  EXPECT_EQ(measure::Region("odeum/radau_iia5").edge({-1, 1}), infinity);
}

}  // namespace
}  // namespace odeum::recording_test
