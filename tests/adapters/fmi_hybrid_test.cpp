// SPDX-License-Identifier: BSD-3-Clause
// FMUs with state events, time events and events of steps, against closed forms and the reference
// outputs of others.
#include <cmath>
#include <sstream>

#include "fmi_hybrid_stage.hpp"
#include "odeum/solvers/own_methods.hpp"
#include "odeum/solvers/pieces.hpp"

namespace odeum::fmi_tests::fmi_hybrid_test {
namespace {

/// h, v of the ball at t by its closed form, and the times at which it bounces up to then.
struct Bounced {
  double h, v;
  std::vector<double> times;
};
Bounced bounced(double t, double e = 0.7, double v_min = 0.1, double g = 9.81) {
  double since = 0, height = 1, speed = 0;
  Bounced at{};
  for (;;) {
    const double landing = since + (speed + std::sqrt(speed * speed + 2 * g * height)) / g;
    if (landing > t) break;
    at.times.push_back(landing);
    speed = e * std::sqrt(speed * speed + 2 * g * height);
    since = landing, height = 0;
    if (speed < v_min) return at;
  }
  at.h = height + speed * (t - since) - g / 2 * (t - since) * (t - since);
  at.v = speed - g * (t - since);
  return at;
}

std::vector<std::vector<double>> reference(const std::string& name) {
  std::istringstream file(read(ODEUM_SOURCE_DIR "/tests/adapters/reference_fmus/" + name));
  std::vector<std::vector<double>> rows;
  std::string line, cell;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    for (rows.emplace_back(); std::getline(cells, cell, ',');)
      rows.back().push_back(std::strtod(cell.c_str(), nullptr));
  }
  return rows;
}

using Hybrid = HybridFmus;

TEST_P(Hybrid, ABallBouncesAsItsClosedFormDoes) {
  const Case c = hybrid(ball());
  ASSERT_TRUE(c.problem.events);
  EXPECT_EQ(c.components, (std::vector<std::string>{"h", "v"}));
  const std::vector<double> stops{0.4, 0.5, 1.5, 2, 2.5, 3};
  for (const char* id : {"odeum/dormand_prince54", "odeum/rodas4", "odeum/radau_iia5"}) {
    const Outcome outcome = run(c, id, stops, 1e-10);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    const std::vector<double> times = bounced(3).times;
    ASSERT_EQ(outcome.events.size(), times.size()) << id;
    // A parabola is exact in each of these methods but for the rounding of sums; each event adds
    // that of its time.
    for (std::size_t k = 0; k < times.size(); ++k) {
      EXPECT_NEAR(outcome.events[k].t, times[k], 1e-12) << id << k;
      EXPECT_NEAR(outcome.events[k].after[1], -0.7 * outcome.events[k].before[1],
                  k + 1 < times.size() ? 1e-15 : 0.1);
    }
    for (std::size_t k = 0; k < stops.size(); ++k) {
      EXPECT_NEAR(outcome.states[2 * k], bounced(stops[k]).h, 1e-11) << id << stops[k];
      EXPECT_NEAR(outcome.states[2 * k + 1], bounced(stops[k]).v, 1e-10) << id << stops[k];
    }
  }
  const Outcome fixed = run(c, "odeum/rk4", {1.5, 3}, 0, 300);
  ASSERT_EQ(fixed.status, Status::ok) << fixed.detail;
  EXPECT_NEAR(fixed.states[0], bounced(1.5).h, 1e-11);
}

// The reference outputs are those of Euler's method in steps of 0.001, whose events happen where
// steps end: ours that locates none does the same operations in another order.
TEST_P(Hybrid, ABallBouncesAsInTheReferenceOutputs) {
  const Case c = hybrid(ball());
  const auto rows = reference("BouncingBall_out.csv");
  ASSERT_EQ(rows.size(), 301U);
  std::vector<double> stops;
  for (std::size_t k = 1; k < rows.size(); ++k) stops.push_back(rows[k][0]);
  const Outcome as_it_comes = run(c, "odeum/explicit_euler_as_it_comes", stops, 0, 3000);
  ASSERT_EQ(as_it_comes.status, Status::ok) << as_it_comes.detail;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_NEAR(as_it_comes.states[2 * k - 2], rows[k][1], 1e-12) << stops[k - 1];
    EXPECT_NEAR(as_it_comes.states[2 * k - 1], rows[k][2], 1e-12) << stops[k - 1];
  }
}

TEST_P(Hybrid, AModelWithoutStatesHasItsOutputsAtStops) {
  const Case c = hybrid(stair());
  EXPECT_EQ(c.components, (std::vector<std::string>{"counter"}));
  const auto rows = reference("Stair_out.csv");
  std::vector<double> stops;
  for (std::size_t k = 1; k < rows.size(); ++k) stops.push_back(rows[k][0]);
  stops.push_back(10);
  for (const char* id : {"odeum/dormand_prince54", "odeum/rk4", "odeum/sdirk4"}) {
    const bool fixed = std::string(id) == "odeum/rk4";
    const Outcome outcome = run(c, id, stops, 1e-6, fixed ? 50 : 0);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    for (std::size_t k = 0; k < stops.size(); ++k)
      EXPECT_EQ(outcome.states[k], k + 1 < rows.size() ? rows[k + 1][1] : 10) << id << stops[k];
    EXPECT_NE(outcome.detail.find("ends it at t = 9"), std::string::npos) << outcome.detail;
    EXPECT_EQ(outcome.events.size(), 9U);
  }
}

TEST_P(Hybrid, ClocksTickAsTheirEquationsSay) {
  const auto output = [](const char* name, unsigned reference) {
    return Written{name, reference, "Integer", "output", "discrete", ""};
  };
  const Case c = hybrid({"{clocks}",
                         10,
                         {output("ticks1", 1),
                          output("ticks2", 2),
                          output("total", 3),
                          {"fifth", 4, "Real", "output", "discrete", ""}}});
  EXPECT_EQ(c.y0, (std::vector<double>{1, 1, 2, 0}));
  const Outcome outcome = run(c, "odeum/bogacki_shampine32", {0.5, 1.5, 4.5, 8.5, 9.5}, 1e-3);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  // At t both have ticked floor(t) + 1 and min(2, floor(t) + 1) times, the latter at 8 and 9, too.
  EXPECT_EQ(outcome.states,
            (std::vector<double>{1, 1, 2, 0, 2, 2, 4, 0, 5, 2, 7, 2, 9, 3, 12, 7, 10, 4, 14, 7}));
}

TEST_P(Hybrid, AModelOfAResourceAloneIsRead) {
  const Case c = hybrid({"{resource}", 1, {{"y", 1, "Integer", "output", "discrete", ""}}}, {}, {},
                        {{"resources/letter.txt", "a"}});
  EXPECT_EQ(c.y0, (std::vector<double>{'a'}));
  const Outcome outcome = run(c, "odeum/rk4", {1}, 0, 4);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  EXPECT_EQ(outcome.states, (std::vector<double>{'a'}));
}

// Up from 4 to 6 in log(6/4), down in log(6/4): T' = 10 - T or -T.
TEST_P(Hybrid, AThermostatSwitchesAtItsLimits) {
  const Case c = hybrid(thermostat());
  for (const char* id : {"odeum/dormand_prince853", "odeum/radau_iia5", "odeum/bdf_variable"}) {
    const Outcome outcome = run(c, id, {4}, 1e-10);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    ASSERT_GT(outcome.events.size(), 8U) << id;
    const double first = std::log(5.0 / 4), half = std::log(6.0 / 4);
    for (std::size_t k = 0; k < outcome.events.size(); ++k)
      // A tolerance of 1e-10 a step, over up to a hundred steps.
      EXPECT_NEAR(outcome.events[k].t, first + static_cast<double>(k) * half, 1e-7) << id << k;
  }
}

TEST_P(Hybrid, AModelIsToldOfEachStepAndActsAtItsEnd) {
  const Model model{"{steps}",
                    2,
                    {{"x", 1, "Real", "output", "continuous", "1"},
                     {"der(x)", 9, "Real", "local", "continuous", "", 1}},
                    0,
                    three() ? "needsCompletedIntegratorStep=\"true\"" : ""};
  if (!three()) {
    // FMI 2 has no word for a model that acts there: one that asks for no event at the start is a
    // differential equation alone.
    EXPECT_FALSE(hybrid(model).problem.events);
    return;
  }
  const Case c = hybrid(model);
  ASSERT_TRUE(c.problem.events);
  const double after = std::exp(-0.7) + 1;
  for (const char* id : {"odeum/rk4", "odeum/rk4_as_it_comes"}) {
    const Outcome outcome = run(c, id, {0.7, 1, 2}, 0, 20);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    ASSERT_EQ(outcome.events.size(), 2U) << id;
    EXPECT_NEAR(outcome.events[0].t, 0.7, 1e-15);
    // rk4 with a step of 0.1: its local error is 1e-5/120.
    EXPECT_NEAR(outcome.states[0], after, 1e-6) << id;
    EXPECT_NEAR(outcome.states[1], after * std::exp(-0.3), 1e-6) << id;
  }
  const Outcome outcome = run(c, "odeum/dormand_prince54", {2}, 1e-6);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  ASSERT_GE(outcome.events.size(), 1U);
  EXPECT_LT(outcome.events[0].before[0], 0.5);
}

TEST_P(Hybrid, ChatteringIsSaid) {
  const Case c = hybrid({"{relay}",
                         2,
                         {{"x", 1, "Real", "output", "continuous", "0.5"},
                          {"der(x)", 9, "Real", "local", "continuous", "", 1}},
                         1});
  const Outcome outcome = run(c, "odeum/dormand_prince54", {2}, 1e-6);
  EXPECT_EQ(outcome.status, Status::step_too_small) << outcome.detail;
  EXPECT_NE(outcome.detail.find("chattering"), std::string::npos) << outcome.detail;
}

TEST_P(Hybrid, EventsWithoutEndAreSaid) {
  const Case c = hybrid(ball(), {{"v_min", "0"}});
  const Outcome outcome = run(c, "odeum/dormand_prince54", {2, 3}, 1e-6);
  EXPECT_EQ(outcome.status, Status::step_too_small) << outcome.detail;
  EXPECT_NE(outcome.detail.find("ever faster"), std::string::npos) << outcome.detail;
  ASSERT_GE(outcome.states.size(), 2U);
  EXPECT_NEAR(outcome.states[0], bounced(2, 0.7, 0).h, 1e-9);
}

// The states in which events are looked for cost evaluations, too: a run that has none left for
// them had missed an event, with status ok.
TEST_P(Hybrid, NoEventIsMissedForABudget) {
  const Case c = hybrid(thermostat());
  bool some = false;
  for (const std::uint64_t budget : {2'000, 20'000, 50'000, 100'000, 200'000}) {
    for (const char* id : {"odeum/cash_karp54_order1", "odeum/cash_karp54_order1_as_it_comes"}) {
      Request request{.mode = Mode::adaptive, .tolerance = 1e-5, .stops = {1, 2}};
      request.budget.evaluations = budget;
      const Outcome outcome = c.entrants.find(id)->solve(request);
      if (outcome.status == Status::ok) {
        EXPECT_EQ(outcome.events.size(), 5U) << id << budget;
      }
      some = some || outcome.status == Status::over_budget;
    }
  }
  EXPECT_TRUE(some);
}

// The judge of a run solves again from states along it, in the process of the laboratory, where no
// model is loaded: that crashed.
TEST_P(Hybrid, OutsideOfItsProcessAModelIsRefused) {
  const Case c = hybrid(ball());
  Request request{.mode = Mode::adaptive, .tolerance = 1e-6, .stops = {1}};
  const Outcome outcome = enrolled(own_solver("rodas4"), c.problem).solve(request);
  EXPECT_EQ(outcome.status, Status::refused);
  EXPECT_NE(outcome.detail.find("in a process of its own"), std::string::npos) << outcome.detail;
}

TEST_P(Hybrid, EventsThatFailAreSaid) {
  const auto model = [](int fault) {
    return Model{"{fault}",
                 2,
                 {{"x", 1, "Real", "output", "continuous", "1"},
                  {"der(x)", 9, "Real", "local", "continuous", "", 1},
                  {"fault", 2, "Integer", "parameter", "fixed", std::to_string(fault)}}};
  };
  const std::pair<int, const char*> faults[] = {{1, "new discrete states without end"},
                                                {2, "do not go on from t = 1"},
                                                {3, "returned error"},
                                                {5, "crashed: Aborted"}};
  for (const auto& [fault, why] : faults) {
    const Case c = hybrid(model(fault), {{"fault", std::to_string(fault)}});
    const Outcome outcome = run(c, "odeum/dormand_prince54", {2}, 1e-6);
    EXPECT_EQ(outcome.status, Status::refused) << fault;
    EXPECT_NE(outcome.detail.find(why), std::string::npos) << fault << ": " << outcome.detail;
  }
  const Case c = hybrid(model(4), {{"fault", "4"}});
  const Outcome outcome = run(c, "odeum/dormand_prince54", {0.5, 2}, 1e-9);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
  EXPECT_NEAR(outcome.states[1], std::exp(-1), 1e-7) << "the state at the end of the model";
}

INSTANTIATE_TEST_SUITE_P(Versions, Hybrid, testing::Values(2, 3));

}  // namespace
}  // namespace odeum::fmi_tests::fmi_hybrid_test
