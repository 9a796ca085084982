// SPDX-License-Identifier: BSD-3-Clause
// Members of a text in lanes are those of runs alone: the same bits and the same counts by explicit
// methods, the same tolerance by Rosenbrock methods.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/text_case.hpp"
#include "odeum/sweep/runner.hpp"
#include "support/catalogue.hpp"

namespace odeum::sweep::lanes_test {
namespace {

constexpr std::uint64_t many = 10'000;

Case case_of_text(const std::string& text) {
  return case_of(cases::text_statements("lanes.yaml", text, "lanes_test").front());
}

Plan plan_of(const Case& c, const std::vector<std::string>& over, const std::string& solver,
             std::uint64_t sample = many) {
  std::vector<Axis> axes;
  for (const std::string& text : over) axes.push_back(axis_of(text));
  Plan plan(c, Members(axes, sample, 1));
  plan.solver = solver;
  plan.request.stops = {c.stops.back()};
  plan.quantities = quantities_of("", c);
  return plan;
}
Plan fixed(Plan plan, std::uint64_t steps) {
  plan.request.steps = steps;
  return plan;
}
Plan adaptive(Plan plan, double tolerance) {
  plan.request.mode = Mode::adaptive;
  plan.request.tolerance = tolerance;
  return plan;
}

/// Calls with what a member is in lanes and alone.
template <class Compare>
void each_member(const Plan& plan, Compare&& compare) {
  Runner runner(plan, plan.base->family({}));
  const std::uint64_t size = plan.members.size();
  const std::vector<Outcome> in_lanes = runner.run_in_lanes(0, size);
  ASSERT_EQ(in_lanes.size(), size) << plan.solver;
  for (std::uint64_t k = 0; k < size && !::testing::Test::HasFailure(); ++k) {
    const Outcome alone = runner.run(parameters_of(plan, k), plan.request);
    SCOPED_TRACE(plan.solver + ", member " + std::to_string(k));
    compare(in_lanes[k], alone);
  }
}
/// To the last bit, but where functions of libmvec are called: to this part of the state.
void expect_as_alone(const Plan& plan, double part = 0) {
  each_member(plan, [=](const Outcome& in_lanes, const Outcome& alone) {
    // What fails runs alone besides.
    EXPECT_EQ(in_lanes.status == Status::ok, alone.status == Status::ok) << alone.detail;
    if (alone.status != Status::ok) return;
    EXPECT_EQ(in_lanes.t, alone.t);
    if (part > 0) {
      ASSERT_EQ(in_lanes.states.size(), alone.states.size());
      for (std::size_t i = 0; i < alone.states.size(); ++i)
        EXPECT_NEAR(in_lanes.states[i], alone.states[i], part * (1 + std::abs(alone.states[i])));
      EXPECT_NEAR(static_cast<double>(in_lanes.counters.steps),
                  static_cast<double>(alone.counters.steps), 1);
      return;
    }
    EXPECT_EQ(in_lanes.states, alone.states);
    EXPECT_EQ(in_lanes.counters.rhs_evaluations, alone.counters.rhs_evaluations);
    EXPECT_EQ(in_lanes.counters.steps, alone.counters.steps);
    EXPECT_EQ(in_lanes.counters.rejected_steps, alone.counters.rejected_steps);
    EXPECT_TRUE(alone.detail.empty()) << alone.detail;
  });
}

constexpr const char* with_functions = R"(
parameters: {k: 2, d: 0.3, p: 2.5}
definitions:
  half: k/2 + sin(d)
states: {x: 1 + k/10, v: 0.5, w: 1}
equations:
  x: v - 0.1*x^3
  v: -k*x - d*abs(v)*v + half*cos(p*t) - hypot(x, 1)/3
  w: -w*exp(-x^2) + log(1 + x^2)*sqrt(1 + w^2) - 0.2*abs(w)^p + 0.1*sign(v) - atan2(x, 2)*tanh(v)
time: {end: 3}
)";

constexpr const char* without_functions = R"(
parameters: {k: 2, d: 0.3, p: 2.5}
states: {x: 1 + k/10, v: 0.5, w: 1}
equations:
  x: v - 0.1*x^3
  v: -k*x - d*abs(v)*v + p*t/(1 + t^2)
  w: -w/(1 + x^2) + sqrt(1 + w^2) - 0.2*w^3 + 0.1*sign(v)
time: {end: 3}
)";

void expect_explicit_methods_as_alone(const char* text, double part) {
  const Case c = case_of_text(text);
  const std::vector<std::string> over{"k~uniform(0.1,9)", "d~uniform(0,2)", "p~normal(2,0.2)"};
  expect_as_alone(fixed(plan_of(c, over, "odeum/rk4"), 30), part);
  // Steps that follow what differs by rounding may differ within the tolerance.
  const double of_tolerance = part > 0 ? 1 : 0;
  expect_as_alone(adaptive(plan_of(c, over, "odeum/dormand_prince54"), 1e-5), of_tolerance * 1e-5);
  for (const char* solver : {"heun", "dormand_prince54", "verner98", "fehlberg78"})
    expect_as_alone(fixed(plan_of(c, over, std::string("odeum/") + solver, 100), 30), part);
  for (const char* solver : {"bogacki_shampine32", "dormand_prince54_pi", "dormand_prince853",
                             "tsitouras54", "verner65", "dormand_prince54_dead_band"})
    expect_as_alone(adaptive(plan_of(c, over, std::string("odeum/") + solver, 100), 1e-7),
                    of_tolerance * 1e-7);
}

TEST(SweepInLanes, ExplicitMethodsGiveTheBitsOfRunsAlone) {
  expect_explicit_methods_as_alone(without_functions, 0);
}

// Vector functions have up to 4 units in the last place, where scalar ones have less than 1: with
// thirty steps of some stages some hundred units of rounding.
TEST(SweepInLanes, FunctionsHaveTheRoundingOfVectorFunctions) {
  expect_explicit_methods_as_alone(with_functions, 1e-12);
}

// Forty unknowns of one form, which are printed as loops with tables.
TEST(SweepInLanes, LoopsOfManyUnknownsAreThoseOfRunsAlone) {
  const Case c = case_of_text(R"(
parameters: {k: 3}
states: {u[1..40]: i/40}
boundaries: {u[0]: 0, u[41]: 1}
equations:
  u[1..40]: k*(u[i-1] - 2*u[i] + u[i+1]) - u[i]^2*sin(i)/(1 + i)
time: {end: 1}
)");
  expect_as_alone(adaptive(plan_of(c, {"k=1..9:33"}, "odeum/dormand_prince54", 0), 1e-6), 1e-12);
}

// They are branches where a member is alone.
TEST(SweepInLanes, ChoicesAreNotRunSo) {
  const Case c = case_of_text(R"(
parameters: {k: 3}
states: {x: 1}
equations:
  x: -k*max(x - 1/2, 0)
time: {end: 1}
)");
  const Plan plan = fixed(plan_of(c, {"k=1..9:33"}, "odeum/rk4", 0), 10);
  EXPECT_TRUE(Runner(plan, c.family({})).run_in_lanes(0, 33).empty());
}

TEST(SweepInLanes, AMemberThatFailsIsLeftToARunAlone) {
  const Case c = case_of_text(R"(
parameters: {a: 1, y0: 1}
states: {y: y0}
equations: {y: a*y^2}
time: {end: 1}
)");
  expect_as_alone(
      adaptive(plan_of(c, {"a=0.5,1.5,-1", "y0=0.5..2:7"}, "odeum/tsitouras54", 0), 1e-6));
  expect_as_alone(fixed(plan_of(c, {"a=0.5,40,-1", "y0=0.5..2:7"}, "odeum/rk4", 0), 20));
  Plan plan = adaptive(plan_of(c, {"a=0.5,0.9,-1", "y0=0.5,1"}, "odeum/tsitouras54", 0), 1e-9);
  plan.request.budget.evaluations = 150;
  expect_as_alone(plan);
}

TEST(SweepInLanes, RosenbrockMethodsKeepTheTolerance) {
  const Case c = tests::find_case("robertson_40");
  const std::vector<std::string> over{"k1~uniform(0.02,0.08)", "k2~loguniform(1e7,6e7)"};
  each_member(adaptive(plan_of(c, over, "odeum/rodas4", 1000), 1e-6), [](const Outcome& in_lanes,
                                                                         const Outcome& alone) {
    ASSERT_EQ(in_lanes.status, Status::ok);
    ASSERT_EQ(alone.status, Status::ok) << alone.detail;
    EXPECT_NEAR(static_cast<double>(in_lanes.counters.steps),
                static_cast<double>(alone.counters.steps), 1);
    for (std::size_t i = 0; i < alone.states.size(); ++i)
      EXPECT_NEAR(in_lanes.states[i], alone.states[i], 1e-6 * (1 + std::abs(alone.states[i])));
  });
}

}  // namespace
}  // namespace odeum::sweep::lanes_test
