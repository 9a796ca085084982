// SPDX-License-Identifier: BSD-3-Clause
// Events that conditions call, with delays, priorities and persistence, in runs and truths, against
// values from closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "odeum/cases/text_truth.hpp"
#include "support/hybrid_text.hpp"

namespace odeum::tests::event_conditions_test {
namespace {

struct Given {
  const char* name;
  const char* text;
  std::vector<double> expected;  ///< the states at the stops
};

const double half = std::log(2.0);
constexpr double tolerance = 1e-10;

const Given all_given[] = {
    {"a delay, twice",
     R"text(
states: {x: 1}
equations: {x: -x}
time: {end: 4, stops: [1, 1.6, 2, 4]}
events:
  - {when: x < 0.5, delay: 1, set: {x: 1}}
)text",
     {std::exp(-1.0), std::exp(-1.6), std::exp(-(1 - half)), std::exp(-(4 - 2 * (1 + half)))}},
    {"values of the call, or of the time it is carried out at",
     R"text(
states: {x: 0, a: 0, b: 0}
equations: {x: 1, a: 0, b: 0}
time: {end: 3, stops: [1, 2, 3]}
events:
  - {at: 1, delay: 1, early: true, set: {a: x}}
  - {when: x >= 1, delay: 1, set: {b: x}}
)text",
     {1, 0, 0, 2, 1, 2, 3, 1, 2}},
    {"persistence",
     R"text(
states: {x: 0, a: 0, b: 0}
equations: {x: 1, a: 0, b: 0}
time: {end: 3, stops: [1.1, 3]}
events:
  - {when: "x > 0.5 and x < 0.7", delay: 0.5, persistent: false, set: {a: 1}}
  - {when: "x > 0.5 and x < 0.7", delay: 0.5, set: {b: 1}}
)text",
     {1.1, 0, 1, 3, 0, 1}},
    {"priorities that are expressions, before orders",
     R"text(
parameters: {p: 2}
states: {x: 0, n: 1}
equations: {x: 1, n: 0}
time: {end: 3, stops: [1, 2, 3]}
events:
  - {at: 1, every: 1, until: 2, priority: x, order: 2, set: {n: 10*n}}
  - {at: 1, every: 1, until: 2, priority: 3 - x, order: 1, set: {n: n + p}}
)text",
     {1, 30, 2, 302, 3, 302}},
    {"a chain at one time",
     R"text(
states: {x: 0, a: 0, b: 0}
equations: {x: 1, a: 0, b: 0}
time: {end: 2, stops: [0.5, 1.25, 2]}
events:
  - {when: "b >= 1 or x > 7", set: {x: x + 10}}
  - {when: a == 2, set: {b: 1}}
  - {when: x >= 1, set: {a: 2}}
)text",
     {0.5, 0, 0, 11.25, 2, 1, 12, 2, 1}},
    {"at the start",
     R"text(
states: {x: 0, a: 0, b: 0, c: 0, d: 0}
equations: {x: 1, a: 0, b: 0, c: 0, d: 0}
time: {end: 2, stops: [1, 2]}
events:
  - {when: t >= 0, initially: false, set: {a: a + 1}}
  - {when: t >= 0, set: {b: b + 1}}
  - {when: x > 0, set: {c: c + 1}}
  - {when: 1 > 0, initially: false, set: {d: d + 1}}
)text",
     {1, 1, 0, 1, 1, 2, 1, 0, 1, 1}},
    {"a stop at the time of an event, which a comparison of the time gives",
     R"text(
states: {x: 0, a: 0}
equations: {x: a, a: 0}
time: {end: 1, stops: [0.3, 0.7, 1]}
events:
  - {when: t >= 0.3, set: {a: 1}}
  - {when: t > 0.7, set: {a: 2}}
)text",
     {0, 1, 0.4, 2, 1, 2}},
    {"a threshold that is set",
     R"text(
states: {x: 0, top: 1}
equations: {x: 1, top: 0}
time: {end: 4, stops: [0.5, 1.5, 4]}
events:
  - {when: x >= top, set: {x: 0, top: 2*top}}
)text",
     {0.5, 1, 0.5, 2, 1, 4}},
    {"a reset that leaves the condition at its edge",
     R"text(
states: {h: 1, v: 0}
equations: {h: v, v: -2}
time: {end: 3.5, stops: [0.5, 1.5, 3.5]}
events:
  - {when: h < 0, set: {v: -v}}
)text",
     {0.75, -1, 0.75, 1, 0.75, 1}},
    {"a ball that is set to rest",
     R"text(
states: {h: 1, v: 0, g: 2}
equations: {h: v, v: -g, g: 0}
time: {end: 6, stops: [0.5, 1.25, 6]}
events:
  - {when: h, falling: true, set: {h: 0, v: "if(abs(v) < 1.5, 0, -v/2)", g: "if(abs(v) < 1.5, 0, g)"}}
)text",
     {0.75, -1, 2, 0.1875, 0.5, 2, 0, 0, 0}},
};

void expect_states(const std::vector<double>& states, const std::vector<double>& expected,
                   double error) {
  ASSERT_EQ(states.size(), expected.size());
  for (std::size_t k = 0; k < states.size(); ++k) EXPECT_NEAR(states[k], expected[k], error) << k;
}

TEST(EventConditions, RunsHaveTheStatesOfClosedForms) {
  for (const Given& given : all_given) {
    const HybridText text(given.text);
    for (const char* solver : {"odeum/dormand_prince54", "odeum/rodas4", "odeum/bdf_variable"}) {
      SCOPED_TRACE(fmt::format("{} {}", given.name, solver));
      const Outcome outcome = text.run(solver, tolerance);
      ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
      expect_states(outcome.states, given.expected, 1e-7);  // the tolerance times many steps
    }
    // Every stop is on the grid; the method is exact for all but the exponentials.
    SCOPED_TRACE(given.name);
    const Outcome fixed = text.run_fixed("odeum/rk4", 1680);
    if (fixed.status != Status::refused) expect_states(fixed.states, given.expected, 1e-7);
  }
}

TEST(EventConditions, TruthsHaveThemToo) {
  for (const Given& given : all_given) {
    SCOPED_TRACE(given.name);
    const HybridText text(given.text);
    const cases::TextTruth truth = cases::truth_of(text.ode);
    EXPECT_EQ(truth.stops, text.problem.stops) << truth.words;
    std::vector<double> states;
    for (const double t : text.problem.stops) {
      std::vector<long double> y(text.problem.states.size());
      ASSERT_TRUE(truth.extended(t, y.data())) << truth.words;
      states.insert(states.end(), y.begin(), y.end());
    }
    EXPECT_LT(truth.extended_floor, 1e-12) << truth.words;
    expect_states(states, given.expected, truth.extended_floor + 2e-15);
  }
}

// Case 00754 of the SBML test suite: the event makes its own threshold an equilibrium, about which
// rounding moves the state. It happened at each turn, half a million times in ten units of time.
TEST(EventConditions, AStateThatRestsOnItsThresholdCallsNoMore) {
  const HybridText text(R"text(
parameters: {k1: 0.75, k2: 0.25}
states: {A: 1, B: 2, C: 1}
equations: {A: -k1*A*B + k2*C, B: -k1*A*B + k2*C, C: k1*A*B - k2*C}
time: {end: 10}
events:
  - {when: A < 0.5, set: {B: 1}}
)text");
  for (const char* solver : {"odeum/rodas4", "odeum/dormand_prince54", "odeum/radau_iia5"}) {
    const Outcome outcome = text.run(solver, tolerance);
    ASSERT_EQ(outcome.status, Status::ok) << solver << ' ' << outcome.detail;
    // Explicit steps stay about the equilibrium by their error, and cross it a few times.
    EXPECT_LE(outcome.events.size(), std::string(solver) == "odeum/dormand_prince54" ? 10U : 1U)
        << solver;
    // The states at the event, to the tolerance times the steps to it.
    const std::vector<double> last(outcome.states.end() - 3, outcome.states.end());
    expect_states(last, {0.5, 1, 1.5}, 1e-8);
  }
}

TEST(EventConditions, ThoseThatCallOneAnotherWithoutEndEndARun) {
  const HybridText text(R"text(
states: {x: 0, a: 0}
equations: {x: 1, a: 0}
time: {end: 2}
events:
  - {when: "x >= 1 and a == 0", set: {a: 1}}
  - {when: a == 1, set: {a: 0}}
)text");
  const Outcome outcome = text.run("odeum/dormand_prince54", tolerance);
  EXPECT_EQ(outcome.status, Status::refused);
  EXPECT_NE(outcome.detail.find("without end"), std::string::npos) << outcome.detail;
  EXPECT_LE(cases::truth_of(text.ode).known_until, 1.0);
}

// Behind each spike lies a pole, close to which the states within steps were computed until the
// whole budget was spent. Izhikevich, IEEE Trans. Neural Networks 14 (2003) 1569; v by SciPy.
TEST(EventConditions, APoleBehindAnEventSpendsNoBudget) {
  const HybridText text(R"text(
states: {v: -65, u: -13}
equations: {v: 0.04*v^2 + 5*v + 140 - u + 10, u: 0.02*(0.2*v - u)}
time: {end: 200}
events:
  - {when: v - 30, rising: true, set: {v: -65, u: u + 8}}
)text");
  for (const char* solver : {"odeum/dormand_prince54", "odeum/verner98"}) {
    const Outcome outcome = text.run(solver, 1e-11);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_EQ(outcome.events.size(), 5U);
    EXPECT_NEAR(outcome.states[outcome.states.size() - 2], -60.541141468, 1e-7) << solver;
  }
}

}  // namespace
}  // namespace odeum::tests::event_conditions_test
