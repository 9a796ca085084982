// SPDX-License-Identifier: BSD-3-Clause
// Events of a text: runs of own methods and peers, and the truth, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/text_truth.hpp"
#include "support/hybrid_text.hpp"

namespace odeum::tests::text_events_test {
namespace {

const char* const ball = R"text(
parameters: {g: 10, r: 0.7}
states: {h: 0.2, v: 0}
equations: {h: v, v: -g}
time: {end: 0.9}
events:
  - {when: h, falling: true, set: {h: 0, v: -r*v}}
)text";
/// Falls 0.2 in 0.2, and bounces after 0.28, 0.196, ...
double height_of_ball(double t) {
  double hit = 0.2, speed = 2;
  if (t < hit) return 0.2 - 5 * t * t;
  for (;;) {
    speed *= 0.7;
    const double flight = speed / 5;
    if (t < hit + flight) return (t - hit) * (speed - 5 * (t - hit));
    hit += flight;
  }
}

const char* const doses = R"text(
parameters: {k: 0.3}
states: {c: 5}
equations: {c: -k*c}
time: {end: 30, stops: [6, 7, 14, 30]}
events:
  - {at: 6, every: 8, until: 22, set: {c: c + 5}}
)text";
double concentration(double t) {
  double c = 5 * std::exp(-0.3 * t);
  for (const double at : {6, 14, 22})
    if (t >= at) c += 5 * std::exp(-0.3 * (t - at));
  return c;
}

const char* const thermostat = R"text(
states: {x: 20, u: 1}
equations: {x: -0.1*(x - 10) + 2*u, u: 0}
time: {end: 60}
events:
  - {when: x - 22, rising: true, set: {u: 0}}
  - {when: x - 19, falling: true, set: {u: 1}}
)text";
double temperature(double t) {
  long double from = 20, begin = 0;
  for (bool on = true;; on = !on) {
    const long double rest = on ? 30 : 10, to = on ? 22 : 19;
    const long double until = begin + 10 * std::log((rest - from) / (rest - to));
    if (t < until) return static_cast<double>(rest + (from - rest) * std::exp(-0.1L * (t - begin)));
    begin = until, from = to;
  }
}

const char* const neuron = R"text(
states: {v: 0}
equations: {v: (20 - v)/10}
time: {end: 100}
events:
  - {when: v - 15, rising: true, set: {v: 0}}
)text";
double potential(double t) {
  const long double period = 10 * std::log(4.0L);
  return static_cast<double>(20 -
                             20 * std::exp(-std::fmod(static_cast<long double>(t), period) / 10));
}

struct ClosedForm {
  const char* name;
  const char* text;
  double (*first)(double t);  ///< its first component
  std::size_t events;
};
const ClosedForm closed_forms[] = {{"ball", ball, height_of_ball, 4},
                                   {"doses", doses, concentration, 3},
                                   {"thermostat", thermostat, temperature, 20},
                                   {"neuron", neuron, potential, 7}};

TEST(TextEvents, RunsOfOwnMethodsAndPeersFollowClosedForms) {
  std::vector<std::string> solvers{"odeum/dormand_prince54",     "odeum/bogacki_shampine32",
                                   "odeum/radau_iia_variable",   "odeum/bdf_variable",
                                   "odeum/gragg_bulirsch_stoer", "odeum/rodas4"};
  // Without gsl/msbdf of GSL 2.7.1: its states at the times of outputs are off by 3e-5 here, at a
  // tolerance of 1e-8, and so are the times of events.
  for (const char* peer :
       {"cvode/bdf", "cvode/adams", "gsl/rk8pd", "odeint/runge_kutta_dopri5", "odeint/rosenbrock4"})
    for (const Solver& solver : all_solvers())
      if (solver.info.id() == peer) solvers.emplace_back(peer);
  for (const ClosedForm& form : closed_forms) {
    const HybridText text(form.text);
    for (const std::string& solver : solvers) {
      SCOPED_TRACE(fmt::format("{} {}", form.name, solver));
      const Outcome outcome = text.run(solver, 1e-8);
      ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
      EXPECT_EQ(outcome.events.size(), form.events);
      const std::size_t n = text.problem.states.size();
      ASSERT_EQ(outcome.states.size(), n * text.problem.stops.size());
      // The tolerance times the number of steps, and of states and slopes of some tens.
      for (std::size_t k = 0; k < text.problem.stops.size(); ++k)
        EXPECT_NEAR(outcome.states[k * n], form.first(text.problem.stops[k]), 2e-5);
    }
  }
}

TEST(TextEvents, FixedStepsKeepTheirOrder) {
  for (const ClosedForm& form : closed_forms)
    for (const char* solver : {"odeum/rk4", "odeum/midpoint", "odeum/implicit_midpoint"}) {
      SCOPED_TRACE(fmt::format("{} {}", form.name, solver));
      const HybridText text(form.text);
      const std::size_t n = text.problem.states.size(), last = text.problem.stops.size() - 1;
      const auto error = [&](std::uint64_t steps) {
        const Outcome outcome = text.run_fixed(solver, steps);
        EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
        EXPECT_EQ(outcome.events.size(), form.events);
        return std::abs(outcome.states[last * n] - form.first(text.problem.stops[last]));
      };
      const double coarse = error(300), fine = error(1200);
      const double order = solver == std::string("odeum/rk4") ? 4 : 2;
      // The last event may fall anywhere within a step: half an order of scatter over a factor
      // of 4.
      EXPECT_LT(fine, std::max(coarse * std::pow(4.0, -(order - 0.5)), 1e-11));
    }
}

TEST(TextEvents, TruthsClaimNoWrongDigit) {
  for (const ClosedForm& form : closed_forms) {
    SCOPED_TRACE(form.name);
    const HybridText text(form.text);
    const cases::TextTruth truth = cases::truth_of(text.ode);
    EXPECT_EQ(truth.stops, text.problem.stops) << truth.words;
    std::vector<long double> y(text.problem.states.size());
    for (const double t : text.problem.stops) {
      ASSERT_TRUE(truth.extended(t, y.data())) << truth.words;
      // The closed forms of ball and doses are computed in double.
      EXPECT_NEAR(static_cast<double>(y[0]), form.first(t), truth.extended_floor + 2e-14);
    }
    EXPECT_LT(truth.extended_floor, 1e-12) << truth.words;
  }
}

TEST(TextEvents, OrderOfWhatHappensAtOnceAndValuesFromThoseBefore) {
  const HybridText text(R"text(
states: {x: 1, y: 2, z: 0}
equations: {x: 0, y: 0, z: 1}
time: {end: 4, stops: [1, 2, 4]}
events:
  - {at: 1, set: {x: y, y: x}}
  - {at: 2, set: {x: x + 1}, order: 2}
  - {at: 2, set: {x: 10*x}, order: 1}
  - {when: z - 3, set: {z: z + 1, x: x + z}}
)text");
  const Outcome outcome = text.run("odeum/dormand_prince54", 1e-10);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  const std::vector<double> expected{2, 1, 1, 21, 1, 2, 24, 1, 5};
  for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(outcome.states[k], expected[k], 1e-8) << k;
}

TEST(TextEvents, AllRootsOfACubicWithinOneStep) {
  for (const double start : {-100.0, -7.0, -5.9, 0.0}) {
    const HybridText text(fmt::format(R"text(
states: {{y: {0}, n: 0}}
equations: {{y: 3*t^2 + 12*t - 4, n: 0}}
time: {{start: {1}, end: 10}}
events:
  - {{when: y, set: {{n: n + 1}}}}
)text",
                                      fmt::format("({0} + 6)*({0} + 2)*({0} - 2)", start), start));
    std::vector<double> roots;
    for (const double root : {-6, -2, 2})
      if (root > start) roots.push_back(root);
    for (const char* solver : {"odeum/dormand_prince54", "odeum/dormand_prince853",
                               "odeum/gragg_bulirsch_stoer", "odeum/radau_iia5"}) {
      const Outcome outcome = text.run(solver, 1e-8);
      ASSERT_EQ(outcome.events.size(), roots.size()) << solver << " from " << start;
      // A height of 1e6 at the start has its rounding and 1e-8 of it as its tolerance.
      for (std::size_t k = 0; k < roots.size(); ++k)
        EXPECT_NEAR(outcome.events[k].t, roots[k], 1e-7) << solver;
    }
  }
}

TEST(TextEvents, OneThatStopsHoldsTheState) {
  const HybridText text(R"text(
states: {x: 1}
equations: {x: -x}
time: {end: 3, stops: [0.5, 1, 3]}
events:
  - {when: x - 0.5, falling: true, stop: true}
)text");
  const Outcome outcome = text.run("odeum/dormand_prince54", 1e-9);
  ASSERT_EQ(outcome.states.size(), 3U) << outcome.detail;
  EXPECT_EQ(outcome.status, Status::ok);
  EXPECT_NEAR(outcome.states[2], 0.5, 1e-8);
  EXPECT_NEAR(outcome.events.at(0).t, std::log(2.0), 1e-8);
  const cases::TextTruth truth = cases::truth_of(text.ode);
  std::vector<long double> y(1);
  ASSERT_TRUE(truth.extended(3, y.data())) << truth.words;
  EXPECT_NEAR(static_cast<double>(y[0]), 0.5, 1e-15);
}

TEST(TextEvents, WithoutEndInAFiniteTimeAndChatteringEndWithASentence) {
  // The ball rests at t = 0.2 + 0.28 / 0.3.
  const HybridText rests(std::string(ball).replace(std::string(ball).find("0.9}"), 4, "2}"));
  const HybridText chatters(R"text(
states: {x: 1, u: -1}
equations: {x: u, u: 0}
time: {end: 3}
events:
  - {when: x, falling: true, set: {u: 1}}
  - {when: x, rising: true, set: {u: -1}}
)text");
  for (const HybridText* text : {&rests, &chatters})
    for (const char* solver : {"odeum/dormand_prince54", "odeum/radau_iia5"}) {
      const Outcome outcome = text->run(solver, 1e-6);
      EXPECT_EQ(outcome.status, Status::step_too_small);
      EXPECT_NE(outcome.detail.find("ever faster"), std::string::npos) << outcome.detail;
    }
  const cases::TextTruth truth = cases::truth_of(rests.ode);
  EXPECT_LT(truth.known_until, 0.2 + 0.28 / 0.3);
  EXPECT_GE(truth.known_until, 1.0) << truth.words;
  EXPECT_LE(cases::truth_of(chatters.ode).known_until, 1.0);
}

// Each of seven spikes is late by up to a step, where the slope is between 0.5 and 2.
TEST(TextEvents, ToTakeThemAsTheyComeCostsTheOrder) {
  const HybridText text(neuron);
  const auto error = [&](const char* solver, std::uint64_t steps) {
    const Outcome outcome = text.run_fixed(solver, steps);
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_EQ(outcome.events.size(), 7U);
    return std::abs(outcome.states.back() - potential(100));
  };
  for (const std::uint64_t steps : {400, 1600, 6400}) {
    const double h = 100.0 / static_cast<double>(steps);
    EXPECT_LT(error("odeum/rk4", steps), 1e-6);
    EXPECT_LT(error("odeum/rk4_as_it_comes", steps), 14 * h);
    EXPECT_GT(error("odeum/rk4_as_it_comes", steps), 0.05 * h);
  }
  for (const char* solver :
       {"odeum/dormand_prince54_as_it_comes", "odeum/bdf_variable_as_it_comes"}) {
    const Outcome outcome = text.run(solver, 1e-8);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_GT(std::abs(outcome.states.back() - potential(100)), 1e-4) << solver;
  }
}

// As they come, they happen at the end of the step that reaches them.
TEST(TextEvents, DosesAsTheyComeAreLate) {
  const HybridText text(doses);
  const Outcome outcome = text.run_fixed("odeum/rk4_as_it_comes", 300);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  EXPECT_NEAR(outcome.states.back(), concentration(30), 1e-5);  // all on the grid
  const Entrants entrants = cases::enroll(text.contest);
  EXPECT_EQ(entrants.find("odeum/no_method_as_it_comes"), nullptr);
  ErasedContest plain = text.contest;
  plain.events = nullptr;
  EXPECT_FALSE(cases::enroll(plain).find("odeum/rk4_as_it_comes")->unfit.empty());
}

TEST(TextEvents, AValueThatIsNotFiniteEndsARun) {
  const HybridText text(R"text(
states: {x: 1}
equations: {x: -1}
time: {end: 3}
events:
  - {when: x, falling: true, set: {x: log(x - 1)}}
)text");
  const Outcome outcome = text.run("odeum/dormand_prince54", 1e-6);
  EXPECT_EQ(outcome.status, Status::refused);
  EXPECT_NE(outcome.detail.find("not finite"), std::string::npos) << outcome.detail;
}

}  // namespace
}  // namespace odeum::tests::text_events_test
