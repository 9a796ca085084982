// SPDX-License-Identifier: BSD-3-Clause
// Reactions make the equations that a person would write for them.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "odeum/formula/text_ode.hpp"
#include "odeum/input/text_file.hpp"
#include "support/problem_texts.hpp"

namespace odeum::reactions_test {
namespace {

using formula::Problem;
using tests::fault_of;

std::vector<double> rates(const Problem& p, double t, const std::vector<double>& y) {
  std::vector<double> f(y.size());
  formula::Evaluator<double>(p.graph, p.equations)(t, y.data(), f.data());
  return f;
}

/// The same rates but for rounding of their largest terms, at states of several sizes.
void expect_same(const Problem& reactions, const Problem& equations) {
  ASSERT_EQ(reactions.states, equations.states);
  EXPECT_EQ(reactions.y0, equations.y0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-3, 1);
  for (int sample = 0; sample < 20; ++sample) {
    std::vector<double> y(reactions.states.size());
    for (double& each : y) each = std::pow(10, exponent(random));
    const std::vector<double> f = rates(reactions, 0, y), g = rates(equations, 0, y);
    double largest = 0;
    for (const double each : g) largest = std::max(largest, std::abs(each));
    for (std::size_t k = 0; k < y.size(); ++k)
      EXPECT_NEAR(f[k], g[k], 1e-14 * largest) << reactions.states[k];
  }
}

Problem of_file(const std::string& stem) {
  const std::string file = ODEUM_SOURCE_DIR "/cases/" + stem + ".yaml";
  return formula::read_problem(file, read_text_file(file, "problem", 100'000));
}

Problem of(const std::string& text) { return formula::read_problem("f", text); }

std::vector<std::string> kept(const Problem& p) {
  std::vector<std::string> names;
  for (const formula::Invariant& each : p.invariants) names.push_back(each.name);
  return names;
}
using Names = std::vector<std::string>;

// Compilers took 12 s of 24,000 reactions without optimisation, and minutes with it.
TEST(Reactions, ThousandsAreCompiledAsSumsOfTerms) {
  constexpr int species = 150, count = 6000;
  std::mt19937 random(9);
  std::uniform_int_distribution<int> any(0, species - 1), rate(1, 9);
  std::string text = "states: {s0: 1";
  for (int k = 1; k < species; ++k) text += fmt::format(", s{}: 0.{}", k, rate(random));
  text += "}\nparameters: {k: 0.3}\nreactions:\n";
  for (int j = 0; j < count; ++j)
    text += fmt::format("  - s{} + s{} -> {} s{}: {}\n", any(random), any(random), 1 + j % 2,
                        any(random), j % 3 == 0 ? "k" : fmt::format("0.0{}", rate(random)));
  const formula::TextOde compiled(of(text + "  - -> s1: 0.1\ntime: {end: 1}\n"));
  if (compiled.how().find("compiled") == std::string::npos) GTEST_SKIP() << compiled.how();
  EXPECT_EQ(compiled.how().find("-O"), std::string::npos) << compiled.how();
  const Problem& p = compiled.problem();
  const std::vector<double> y(p.y0.begin(), p.y0.end()), f = rates(p, 0, y);
  std::vector<double> g(y.size());
  compiled.rhs(0, y.data(), g.data());
  const formula::TextOde interpreted(p, formula::TextOde::Code::interpreted);
  const std::size_t n = y.size();
  std::vector<double> j(n * n), i(n * n);
  compiled.view().jacobian(compiled.view().problem, 0, y.data(), j.data());
  interpreted.view().jacobian(interpreted.view().problem, 0, y.data(), i.data());
  const auto expect_near = [](const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (const double each : b) largest = std::max(largest, std::abs(each));
    // Some hundred terms in another order, which may cancel to a hundredth.
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-12 * largest) << k;
  };
  expect_near(g, f);
  expect_near(j, i);
}

TEST(Reactions, RobertsonsAreItsEquations) {
  const Problem p = of(R"(parameters: {k1: 0.04, k2: 3e7, k3: 1e4}
states: {y0: 1, y1: 0, y2: 0}
reactions:
  - y0 -> y1: k1
  - y1 + y1 -> y1 + y2: k2
  - y1 + y2 -> y0 + y2: k3
time: {end: 40}
)");
  expect_same(p, of_file("robertson"));
  EXPECT_EQ(kept(p), Names{"sum_of_y0_y1_y2"});
}

TEST(Reactions, TheHighIrradianceResponseIsItsEquations) {
  const Problem p = of(R"(states: {y0: 1, y1: 0, y2: 0, y3: 0, y4: 0, y5: 0, y6: 0, y7: 0.0057}
reactions:
  - -> y0: 0.0007
  - y0 <-> y1: [1.71, 0.43]
  - y1 -> y3: 8.32
  - y2 -> y0: 8.32
  - y2 <-> y3: [1.71, 0.43]
  - y3 -> y5: 0.69
  - y4 -> y2: 0.035
  - y4 <-> y5: [1.71, 0.43]
  - y5 + y7 <-> y6: [280, 0.69]
  - y6 -> y4 + y7: 0.43
  - y6 -> y7: 0.69
time: {end: 321.8122}
)");
  expect_same(p, of_file("hires"));
  EXPECT_EQ(kept(p), Names{"sum_of_y6_y7"});
}

TEST(Reactions, AirPollutionIsItsEquations) {
  expect_same(
      of(R"(states: {y1: 0, y2: 0.2, y3: 0, y4: 0.04, y5: 0, y6: 0, y7: 0.1, y8: 0.3, y9: 0.01,
         y10: 0, y11: 0, y12: 0, y13: 0, y14: 0, y15: 0, y16: 0, y17: 0.007, y18: 0, y19: 0, y20: 0}
reactions:
  - y1 -> y2 + y3: 0.35
  - y2 + y4 -> y1: 26.6
  - y5 + y2 -> y1 + y6: 1.23e4
  - y7 -> 2 y5 + y8: 8.6e-4
  - y7 -> y8: 8.2e-4
  - y7 + y6 -> y5 + y8: 1.5e4
  - y9 -> y5 + y8 + y10: 1.3e-4
  - y9 + y6 -> y11: 2.4e4
  - y11 + y2 -> y1 + y10 + y12: 1.65e4
  - y11 + y1 <-> y13: [9e3, 0.022]
  - y10 + y2 -> y1 + y14: 1.2e4
  - y14 -> y5 + y7: 1.88
  - y1 + y6 -> y15: 1.63e4
  - y3 -> y4: 4.8e6
  - y4 -> y16: 3.5e-4
  - y4 -> y3: 0.0175
  - y16 -> 2y6: 1e8
  - y16 -> y3: 4.44e11
  - y17 + y6 -> y5 + y18: 1.24e3
  - y19 -> y2: 2.1
  - y19 -> y1 + y3: 5.78
  - y1 + y4 -> y19: 0.0474
  - y19 + y1 <-> y20: [1.78e3, 3.12]
time: {end: 60}
)"),
      of_file("problems/pollution"));
}

TEST(Reactions, AChainHasItsClosedForm) {
  // Bateman's; read_problem refuses what does not fulfil the equations.
  const Problem p = of(R"(parameters: {k: 2, l: 0.5}
states: {A: 3, B: 0, C: 0}
reactions: [A -> B: k, B -> C: l]
time: {end: 4}
exact:
  A: 3*exp(-k*t)
  B: 3*k/(l - k)*(exp(-k*t) - exp(-l*t))
  C: 3 - 3*exp(-k*t) - 3*k/(l - k)*(exp(-k*t) - exp(-l*t))
)");
  EXPECT_EQ(kept(p), Names{"sum_of_A_B_C"});
  EXPECT_EQ(p.equations_text, "A -> B, B -> C");
}

TEST(Reactions, RatesStoichiometryAndThirdBodies) {
  const Problem p = of(R"(parameters: {n: 1.5, water: 55, k: 2}
definitions: {M: A + B + 3*C}
states: {A: 4, B: 1, C: 2}
reactions:
  - A -> B: {rate: k*A/(1 + A)}
  - A + M -> B + M: 0.1
  - (n) A + water -> 0.5 C: 0.25
  - 2*B -> 0: 3
time: {end: 1}
)");
  const double a = 2, b = 3, c = 0.5, hill = 2 * a / (1 + a), third = 0.1 * a * (a + b + 3 * c),
               power = 0.25 * a * std::sqrt(a) * 55, pairs = 3 * b * b;
  const std::vector<double> f = rates(p, 0, {a, b, c});
  EXPECT_DOUBLE_EQ(f[0], -hill - third - 1.5 * power);
  EXPECT_DOUBLE_EQ(f[1], hill + third - 2 * pairs);
  EXPECT_DOUBLE_EQ(f[2], 0.5 * power);
  // A coefficient that is a parameter keeps its name.
  Problem named = formula::read_problem(
      "f", "parameters: {n: 2}\nstates: {A: 1, B: 0}\nreactions: [(n) A -> B: 1]\ntime: {end: 1}\n",
      {}, formula::Parameters::names);
  EXPECT_TRUE(kept(named).empty());
  ASSERT_EQ(named.graph.definitions().front().name, "n");
}

TEST(Reactions, Compartments) {
  // 2 A + B/2 is kept: the volumes are 2 and 1/2.
  const Problem p = of(R"(parameters: {V: 2, k: 0.3, l: 0.1}
compartments:
  cell: {volume: V, species: [A]}
  outside: {volume: 0.5, species: [B]}
states: {A: 1, B: 0}
reactions:
  - A -> B: k
  - B -> A: {rate: l*B*cell, in: outside}
time: {end: 1}
)");
  const std::vector<double> f = rates(p, 0, {3, 5});
  const double there = 0.3 * 3 * 2, back = 0.1 * 5 * 2 * 0.5;  // amounts in unit time
  EXPECT_DOUBLE_EQ(f[0], (back - there) / 2);
  EXPECT_DOUBLE_EQ(f[1], (there - back) / 0.5);
  ASSERT_EQ(kept(p), Names{"sum_of_A_B"});
  double sum = 0;
  const double y[] = {3, 5};
  formula::Evaluator<double>(p.graph, {p.invariants[0].value})(0, y, &sum);
  EXPECT_DOUBLE_EQ(sum, 3 * 2 + 5 * 0.5);
}

TEST(Reactions, StandBesideEquations) {
  const Problem p = of(R"(states: {A: 1, B: 0, T: 300}
equations: {T: 20*A, B: -7}
reactions: [A -> B: exp(-100/T)]
time: {end: 1}
)");
  const std::vector<double> f = rates(p, 0, {2, 1, 400});
  EXPECT_DOUBLE_EQ(f[0], -2 * std::exp(-0.25));
  EXPECT_DOUBLE_EQ(f[1], 2 * std::exp(-0.25) - 7);
  EXPECT_EQ(f[2], 40);
  EXPECT_TRUE(kept(p).empty());
}

TEST(Reactions, SumsOfEnzymesHaveNoNegativeWeights) {
  const Problem p = of(R"(states: {E: 1, S: 5, ES: 0, P: 0, D: 0}
reactions: [E + S <-> ES: [1, 2], ES -> E + P: 3, 2 P <-> D: [1, 1]]
time: {end: 1}
)");
  EXPECT_EQ(kept(p), (Names{"sum_of_E_ES", "sum_of_S_ES_P_2D"}));
}

TEST(Reactions, OfIndexedStates) {
  const Problem p = of(R"(states: {u[1..3]: i}
reactions: [u[1] -> u[2]: 1, u[2] + u[3] -> 2 u[3]: 0.5]
time: {end: 1}
)");
  EXPECT_EQ(rates(p, 0, {2, 3, 4}), (std::vector<double>{-2, 2 - 6, 6}));
}

TEST(Reactions, FaultsHaveTheirPlace) {
  const auto fault = [](const std::string& reaction, const std::string& more = "") {
    return fault_of("parameters: {k: 1}\nstates: {A: 1, B: 0}\n" + more + "reactions:\n  - " +
                    reaction + "\ntime: {end: 1}\n");
  };
  const auto expect = [](const std::string& got, const std::string& begin,
                         const std::string& part) {
    EXPECT_TRUE(got.starts_with(begin) && got.find(part) != std::string::npos)
        << "got       " << got << "\nexpected  " << begin << " ... " << part;
  };
  EXPECT_EQ(fault("A -> B: k"), "");
  expect(fault("A + Bb -> B: k"), "4:9:", "a species that is nowhere declared; got Bb");
  expect(fault("A -> -2 B: k"), "4:10:", "a stoichiometry that is not positive; got -2");
  expect(fault("A -> 0 B: k"), "4:10:", "not positive; got 0");
  expect(fault("A => B: k"), "4:5:", "no arrow");
  expect(fault("A -> B -> A: k"), "4:12:", "expected + and a species");
  expect(fault("A -> B +: k"), "4:13:", "no species");
  expect(fault("0 -> 0: k"), "4:5:", "no species");
  expect(fault("A -> B: q"), "4:13:", "unknown name");
  expect(fault("A -> B"), "4:5:", "a reaction and its rate");
  expect(fault("A <-> B: k"), "4:14:", "expected two: [forward, backward]");
  expect(fault("A -> B: [k, k]"), "4:13:", "got 2 constants, expected one");
  expect(fault("A -> B: {in: cell}"), "4:13:", "got no rate");
  expect(fault("A -> B: {rate: k, in: cell}"), "4:27:", "there are no compartments");
  expect(fault("A -> B: {rate: A/B}"), "4:5:", "a rate that is not finite at the start");
  expect(fault("A -> A: k"), "2:16:", "missing for a state; got none for B");
  expect(fault("A -> B: k", "compartments: {c: {volume: -1, species: [A]}}\n"),
         "3:28:", "expected a positive number");
  expect(fault("A -> B: k", "compartments: {c: {volume: 1, species: [A]}}\n"),
         "5:5:", "a species in no compartment");
  expect(fault("A -> B: k", "compartments: {c: {volume: 1, species: [A, k]}}\n"),
         "3:44:", "no state; got k");
  expect(fault("A + B -> A: k",
               "compartments: {c: {volume: 1, species: [A]}, d: {volume: 2, species: [B]}}\n"),
         "5:5:", "species of several compartments react");
}

}  // namespace
}  // namespace odeum::reactions_test
