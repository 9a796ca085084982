// SPDX-License-Identifier: BSD-3-Clause
// Steps end at the times that a text names: a jump in t alone ends no run, and none steps over a
// pulse.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/cases/text_switches.hpp"
#include "odeum/formula/text_ode.hpp"

namespace odeum::tests::text_switches_test {
namespace {

/// The contest of a text, interpreted: the tests run without a compiler.
struct TextContest {
  explicit TextContest(const std::string& text)
      : problem(formula::read_problem("switches.yaml", text)),
        ode(std::make_shared<formula::TextOde>(problem, formula::TextOde::Code::interpreted)),
        contest{ode->view(), ode, static_cast<double>(problem.t0),
                std::make_shared<const std::vector<double>>(problem.y0.begin(), problem.y0.end()),
                nullptr} {
    contest.switches = cases::switches_of(problem);
  }
  Outcome run(const std::string& solver, Request request) const {
    return cases::enroll(contest).find(solver)->solve(request);
  }

  formula::Problem problem;
  std::shared_ptr<formula::TextOde> ode;
  ErasedContest contest;
};

Request to_a_tolerance(double tolerance, std::vector<double> stops) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = Tolerance(tolerance, std::vector<double>{tolerance});
  request.stops = std::move(stops);
  return request;
}

const char* const niles = R"text(
states: {x1: 0, x2: 0, x3: 0, x4: 0}
definitions: {on: "if(t > 1, 1, 0)"
}
equations:
  x1: 1e9 + 5e4*x3 - 50*x1
  x2: 40*x1 - 3.3e3*x2
  x3: 2e3*x2 - 5e4*x3 + 3.5e7*on*x4
  x4: 1e3*x2 - on*5e7*x4
time: {end: 2}
)text";
const char* const pulse = R"text(
states: {n: 0}
definitions: {on: "if(t > 5, if(t < 6, 1, 0), 0)"
}
equations: {n: "on*(1 - n) - n"}
time: {end: 10}
)text";
const char* const mild_then_stiff = R"text(
states: {y: 1}
equations: {y: "if(t < 1e-3, -y, -1e6*y)"
}
time: {end: 10}
)text";
const char* const step_at_one = R"text(
states: {x: 1}
equations: {x: '-x + if(t >= 1, 5, 0)'}
time: {end: 3}
)text";

std::vector<std::string> with_peers(std::vector<std::string> solvers) {
  for (const Solver& solver : all_solvers())
    if (solver.info.library != "odeum" && solver.info.adaptive && solver.info.family != "engine")
      solvers.push_back(solver.info.id());
  return solvers;
}

TEST(TextSwitches, AJumpOfAStiffSystemEndsNoRun) {
  const TextContest text(niles);
  // Values of SciPy's Radau at 1e-12, in two pieces.
  const std::vector<double> end{57894747.957885, 701754.52140309, 37894.744158268, 14.035090428063};
  for (const char* solver : {"odeum/rodas4", "odeum/radau_iia5", "odeum/sdirk4", "odeum/seulex",
                             "odeum/bdf_variable", "odeum/esdirk43"}) {
    const Outcome outcome = text.run(solver, to_a_tolerance(1e-8, {2}));
    ASSERT_EQ(outcome.status, Status::ok) << solver << ": " << outcome.detail;
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(outcome.states[i], end[i], 1e-6 * (1 + end[i])) << solver;
  }
}

TEST(TextSwitches, NoRunStepsOverAPulse) {
  const TextContest text(pulse);
  const double end = 0.5 * (1 - std::exp(-2.0)) * std::exp(-4.0);
  for (const std::string& solver : with_peers(
           {"odeum/verner65", "odeum/dormand_prince853", "odeum/radau_iia9", "odeum/gauss6"})) {
    const Entrants all = cases::enroll(text.contest);
    const Entrant* const entrant = all.find(solver);
    if (!entrant->solve) continue;
    const Outcome outcome = entrant->solve(to_a_tolerance(1e-7, {10}));
    ASSERT_EQ(outcome.status, Status::ok) << solver << ": " << outcome.detail;
    EXPECT_NEAR(outcome.states[0], end, 1e-4) << solver;
  }
}

TEST(TextSwitches, AConditionHoldsOnBothSides) {
  const TextContest text(step_at_one);
  const double end = 5 - 5 * std::exp(-2.0) + std::exp(-3.0);
  Request request = to_a_tolerance(1e-9, {0.5, 1, 3});
  request.record_steps = true;
  const Outcome outcome = text.run("odeum/dormand_prince54", request);
  ASSERT_EQ(outcome.status, Status::ok);
  ASSERT_EQ(outcome.states.size(), 3U);
  EXPECT_NEAR(outcome.states[1], std::exp(-1.0), 1e-8);
  EXPECT_NEAR(outcome.states[2], end, 1e-8);
  // A stage on the other side would reject steps down to the rounding of t.
  EXPECT_LT(outcome.counters.rejected_steps, 5U);
  EXPECT_TRUE(std::ranges::binary_search(outcome.step_ends, 1.0));
}

TEST(TextSwitches, OutputsLieBetweenSteps) {
  const TextContest text(pulse);
  Request request = to_a_tolerance(1e-8, {});
  for (int k = 1; k <= 40; ++k) request.stops.push_back(0.25 * k);
  const Outcome alone = text.run("odeum/dormand_prince54", to_a_tolerance(1e-8, {10}));
  request.over_stops = true;
  const Outcome outcome = text.run("odeum/dormand_prince54", request);
  ASSERT_EQ(outcome.states.size(), 40U);
  EXPECT_EQ(outcome.states.back(), alone.states.back());
  EXPECT_EQ(outcome.counters.steps, alone.counters.steps);
  for (int k = 1; k <= 20; ++k) EXPECT_EQ(outcome.states[static_cast<std::size_t>(k - 1)], 0);
}

TEST(TextSwitches, ASwitchMayMakeTheProblemStiff) {
  const TextContest text(mild_then_stiff);
  for (const char* solver : {"odeum/rodas4", "odeum/radau_iia5", "odeum/radau_iia9"}) {
    const Outcome outcome = text.run(solver, to_a_tolerance(1e-8, {1e-3, 10}));
    ASSERT_EQ(outcome.status, Status::ok) << solver << ": " << outcome.detail;
    EXPECT_NEAR(outcome.states[0], std::exp(-1e-3), 1e-7) << solver;
    EXPECT_NEAR(outcome.states[1], 0, 1e-7) << solver;
  }
}

TEST(TextSwitches, AStopBesideASwitchIsTheSameTime) {
  // 0.1 + 0.2 is the double after 0.3.
  const TextContest text(
      "states: {x: 1}\nequations: {x: \"if(t > 0.1 + 0.2, 1, -x)\"}\ntime: {end: 1}\n");
  const double end = std::exp(-0.3) + 0.7;
  for (const char* solver : {"odeum/rodas4", "odeum/radau_iia5", "cvode/bdf", "gsl/rkf45"}) {
    const Entrants all = cases::enroll(text.contest);
    const Entrant* const entrant = all.find(solver);
    if (!entrant || !entrant->solve) continue;
    const Outcome outcome = entrant->solve(to_a_tolerance(1e-8, {0.3, 1}));
    ASSERT_EQ(outcome.status, Status::ok) << solver << ": " << outcome.detail;
    ASSERT_EQ(outcome.states.size(), 2U) << solver;
    EXPECT_NEAR(outcome.states[0], std::exp(-0.3), 1e-6) << solver;
    EXPECT_NEAR(outcome.states[1], end, 1e-6) << solver;
  }
}

TEST(TextSwitches, AFixedStepDoesNotMove) {
  const TextContest text(step_at_one);
  Request request;
  request.steps = 7;
  request.stops = {3};
  const Outcome outcome = text.run("odeum/rk4", request);
  EXPECT_EQ(outcome.counters.steps, 7U);
}

TEST(TextSwitches, AProblemWithoutTimesHasNone) {
  const formula::Problem problem = formula::read_problem(
      "state.yaml", "states: {x: 1}\nequations: {x: \"if(x > 0.5, -x, 1)\"}\ntime: {end: 1}\n");
  EXPECT_FALSE(cases::switches_of(problem));
}

// Crossing v = 0 again and again, a tolerance apart, rodas4 took 2e9 evaluations.
TEST(TextSwitches, ARunThatSlidesEndsSoonAndSaysWhy) {
  const Case c = case_of(cases::text_statements("coulomb.yaml",
                                                "states: {v: 10}\nequations: {v: -2.94*sign(v)}\n"
                                                "time: {end: 10}\n",
                                                "coulomb", {})
                             .front());
  const Outcome outcome = c.entrants.find("odeum/rodas4")->solve(to_a_tolerance(1e-8, {10}));
  EXPECT_EQ(outcome.status, Status::over_budget);
  EXPECT_LT(outcome.counters.rhs_evaluations, 6'000'000U);
  EXPECT_NE(outcome.detail.find("(sliding), from t = 3.4013605"), std::string::npos)
      << outcome.detail;
  // Before that time it is bounded by nothing.
  EXPECT_EQ(c.entrants.find("odeum/rodas4")->solve(to_a_tolerance(1e-8, {3})).status, Status::ok);
}

}  // namespace
}  // namespace odeum::tests::text_switches_test
