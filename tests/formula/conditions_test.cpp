// SPDX-License-Identifier: BSD-3-Clause
// Conditions of several comparisons, and floor, ceil, mod: in values, code, intervals and truths.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/text_truth.hpp"
#include "odeum/formula/interval.hpp"
#include "odeum/formula/lane_code.hpp"
#include "odeum/formula/switch_times.hpp"
#include "odeum/formula/text_ode.hpp"
#include "support/problem_texts.hpp"

namespace odeum::conditions_test {
namespace {

using formula::TextOde;

struct Value {
  const char* expression;  ///< of x = 0.5 and y = -2.5
  double value;
};
const Value values[] = {{"if(x > 0 and y < 0, 1, 2)", 1},
                        {"if(x > 0 and y > 0, 1, 2)", 2},
                        {"if(x > 0 or y > 0, 1, 2)", 1},
                        {"if(x < 0 or y > 0, 1, 2)", 2},
                        {"if(not x > 0, 1, 2)", 2},
                        {"if(not (x > 0 and y > 0), 1, 2)", 1},
                        {"if(not not x > 0, 1, 2)", 1},
                        {"if(!(x > 0) || y < 0, 1, 2)", 1},
                        {"if(x > 0 && y < 0 && x + y < 0, 1, 2)", 1},
                        // `and` binds before `or`.
                        {"if(x > 0 or y > 0 and x < 0, 1, 2)", 1},
                        {"if((x > 0 or y > 0) and x < 0, 1, 2)", 2},
                        {"if(0 < x < 1, 1, 2)", 1},
                        {"if(0 < x < 0.25, 1, 2)", 2},
                        {"if(1 > x >= 0.5 == 0.5, 1, 2)", 1},
                        {"if(-3 <= y < x <= 0.5 and x != y, 1, 2)", 1},
                        {"if((x + 1)*2 > 2 and (y) < (x), 1, 2)", 1},
                        {"if(((x) > 0), 1, 2)", 1},
                        {"if(x > 0 and -y > 0, 1, 2)", 1},
                        {"if(max(x, y) > 0 and if(y < 0, 1, -1) > 0, 1, 2)", 1},
                        {"floor(y)", -3},
                        {"floor(x)", 0},
                        {"ceil(y)", -2},
                        {"ceil(x)", 1},
                        {"mod(y, 2)", 1.5},
                        {"mod(7*x, 2)", 1.5},
                        {"mod(x, -2)", -1.5},
                        {"mod(x + 24*3, 24)", 0.5},
                        {"floor(-y) + ceil(-x)*10", 2}};

/// The expressions of states x and y.
std::string text_of_states() {
  std::string states = "states:\n  x: 0.5\n  y: -2.5\n", equations = "equations:\n  x: 1\n  y: 1\n";
  for (std::size_t k = 0; k < std::size(values); ++k) {
    states += fmt::format("  s{}: 0\n", k);
    equations += fmt::format("  s{}: \"{}\"\n", k, values[k].expression);
  }
  return states + equations + "time: {end: 1}\n";
}

TEST(Conditions, HaveTheirValueInEveryCode) {
  for (const auto code : {TextOde::Code::compiled, TextOde::Code::interpreted}) {
    const TextOde ode(formula::read_problem("f", text_of_states()), code);
    const std::vector<long double>& y_extended = ode.problem().y0;
    const std::vector<double> y(y_extended.begin(), y_extended.end());
    std::vector<double> f(ode.size());
    std::vector<long double> f_extended(ode.size());
    ode.rhs(0, y.data(), f.data());
    ode.rhs_extended(0, y_extended.data(), f_extended.data());
    for (std::size_t k = 0; k < std::size(values); ++k) {
      EXPECT_EQ(f[k + 2], values[k].value) << values[k].expression;
      EXPECT_EQ(f_extended[k + 2], values[k].value) << values[k].expression;
    }
  }
}

TEST(Conditions, OfConstantsAreFolded) {
  for (const Value& each : values) {
    const formula::Problem p =
        formula::read_problem("f", fmt::format("parameters: {{x: 0.5, y: -2.5}}\nstates: {{z: 0}}\n"
                                               "equations: {{z: \"{}\"}}\ntime: {{end: 1}}\n",
                                               each.expression));
    ASSERT_TRUE(p.graph.is_constant(p.equations[0])) << each.expression;
    EXPECT_EQ(p.graph[p.equations[0]].value, each.value) << each.expression;
  }
}

TEST(Conditions, AreDecidedForIntervals) {
  const formula::Problem p = formula::read_problem("f", text_of_states());
  formula::Enclosure enclosure(p.graph, p.equations);
  const auto box = [](double low, double high) {
    formula::Intervals all;
    all.fill({low, high});
    return all;
  };
  std::vector<formula::Intervals> y(p.states.size(), box(0, 0));
  // Where all of a box is on one side the branch is known, which is 1 or 2; mod(7*x, 2) and x ==
  // 0.5 vary in it.
  y[0] = box(0.49, 0.51), y[1] = box(-2.51, -2.49);
  const auto& all = enclosure(box(0, 0), y);
  for (std::size_t k = 0; k < std::size(values); ++k) {
    const formula::Interval& v = all[enclosure.place(k + 2)][0];
    EXPECT_TRUE(v.low <= values[k].value && values[k].value <= v.high) << values[k].expression;
    const std::string text = values[k].expression;
    if (text.starts_with("if") && text.find("0.5") == std::string::npos) {  // 1 or 2, rounded
      EXPECT_LT(v.width(), 1e-14) << text;
    }
  }
}

TEST(Conditions, MistakesNameTheirCause) {
  const auto expect = [](const std::string& equation, const std::string& part) {
    const std::string fault = tests::fault_of(tests::with_equation(equation));
    EXPECT_NE(fault.find(part), std::string::npos) << equation << '\n' << fault;
  };
  expect("if(x > 0 and 1, 1, 2)", "no comparison beside and");
  expect("if(x or x > 0, 1, 2)", "no comparison beside or");
  expect("if(not x, 1, 2)", "no comparison after not");
  expect("if(x > 0 & x < 1, 1, 2)", "expected && between conditions");
  expect("if((x > 0)*2 > 1, 1, 2)", "a condition in place of a number");
  expect("if((x > 0) == 1, 1, 2)", "a condition in place of a number");
  expect("if(x <> 0, 1, 2)", "expected < <= > >= == or !=");
  expect("if(x => 0, 1, 2)", "expected < <= > >= == or !=");
  expect("x and 1", "and outside of a condition");
  expect("x && 1", "outside of a condition");
  expect("not and x", "not outside of a condition");
  expect("not (x > 0)", "not outside of a condition");
  expect("if(not and x > 0, 1, 2)", "got and, expected a comparison there");
  expect("if(x > 0 or or x < 2, 1, 2)", "got or, expected a comparison there");
  expect("1 - x % 2", "expected mod(a, b)");
  expect("\"x > 0 ? 1 : 2\"", "if(condition, a, b)");
  expect("2*pow(x, 2)", "expected x^y");
  expect("piecewise(1, x > 0, 2)", "expected if(condition, a, b)");
  expect("heaviside(x - 1)", "expected if(x >= 0, 1, 0)");
  expect("ln(x)", "expected log");
  expect("mod(x)", "the number of arguments of mod; got 1, expected 2");
  expect("mod(x, 0)", "division by zero");
  EXPECT_NE(tests::fault_of("states: {and: 1}\nequations: {and: 1}\ntime: {end: 1}\n")
                .find("a word of conditions"),
            std::string::npos);
  // A name that begins like a word is none.
  EXPECT_EQ(tests::fault_of("states: {order: 1, nothing: 2}\ntime: {end: 1}\nequations: {order: "
                            "'if(nothing > 1 or order > 2, 1, 2)', nothing: 0}\n"),
            "");
}

TEST(WholeNumbers, HaveDerivativesBetweenTheirJumps) {
  const TextOde ode(formula::read_problem(
      "f",
      "states: {x: 0.5, y: 3.7}\nequations: {x: 'mod(y, x)', y: floor(y)*x + ceil(x)}\n"
      "time: {end: 1}\n"));
  const double y[] = {0.5, 3.7};
  double j[4];
  ode.view().jacobian(ode.view().problem, 0, y, j);
  // mod(y, x) = y - 7 x here, and floor(y) x + ceil(x) = 3 x + 1.
  EXPECT_DOUBLE_EQ(j[0], -7);
  EXPECT_DOUBLE_EQ(j[1], 1);
  EXPECT_DOUBLE_EQ(j[2], 3);
  EXPECT_DOUBLE_EQ(j[3], 0);
  EXPECT_FALSE(ode.analysis().structure.smooth);
}

TEST(WholeNumbers, AreComputedInLanes) {
  const TextOde ode(formula::read_problem("f",
                                          "parameters: {k: 2}\nstates: {x: 0.5}\n"
                                          "equations: {x: 'k*floor(x) + abs(x)'}\ntime: {end: 1}\n",
                                          {}, formula::Parameters::names));
  const LaneView lanes = formula::compile_lanes(ode);
  if (!lanes.rhs) GTEST_SKIP() << ode.how();
  std::vector<Lanes> constants(lanes.constants, Lanes(2));
  const Lanes* const problem = constants.data();
  const Lanes t = 0;
  Lanes x = 0, f = 0, slope = 0;
  for (std::size_t k = 0; k < Lanes::count; ++k) x.set(k, static_cast<double>(k) - 0.5);
  lanes.rhs(&problem, &t, &x, &f);
  lanes.jacobian(&problem, &t, &x, &slope);
  for (std::size_t k = 0; k < Lanes::count; ++k) {
    EXPECT_EQ(f[k], 2 * std::floor(x[k]) + std::abs(x[k]));
    EXPECT_EQ(slope[k], x[k] < 0 ? -1 : 1);
  }
}

/// Truths of texts with switches, against closed forms: each switch is located.
struct Known {
  const char* text;
  double end;
};
const Known knowns[] = {
    // A dose every 6 h for 1 h each: the time inside of doses up to t = 20 is 4.
    {"states: {x: 0}\nequations: {x: 'if(mod(t, 6) < 1, 1, 0)'}\ntime: {end: 20, stops: [20]}\n",
     4},
    // 0 + 1 + 2 + 3 + 4 half
    {"states: {x: 0}\nequations: {x: floor(t)}\ntime: {end: 4.5, stops: [4.5]}\n", 8},
    // x' = 1 + floor(x): 1, 1/2, 1/3 to x = 3, then 4: (t - 11/6) 4 + 3
    {"states: {x: 0}\nequations: {x: 1 + floor(x)}\ntime: {end: 2, stops: [2]}\n",
     3 + 4 * (2 - 11. / 6)},
    {"states: {x: 0}\nequations: {x: 'if(1 < t < 2 or 3 <= t <= 3.5, 2, 0)'}\n"
     "time: {end: 5, stops: [5]}\n",
     3},
    // x' = 2 to x = 1, then 1.
    {"states: {x: 0}\nequations: {x: 'if(not (x > 1 and t > 0), 2, 1)'}\n"
     "time: {end: 2, stops: [2]}\n",
     2.5}};

TEST(Conditions, SwitchesAreLocatedByTheTruth) {
  for (const Known& each : knowns) {
    const auto ode = std::make_shared<const TextOde>(formula::read_problem("f", each.text),
                                                     TextOde::Code::interpreted);
    const cases::TextTruth truth = cases::truth_of(ode);
    long double x = 0;
    ASSERT_TRUE(truth.extended && truth.extended(ode->problem().stops.back(), &x))
        << each.text << truth.words;
    EXPECT_NEAR(static_cast<double>(x), each.end, 1e-10) << each.text << truth.words;
  }
}

TEST(Conditions, WholeNumbersOfTheTimeJumpAtKnownTimes) {
  const formula::Problem p =
      formula::read_problem("f", "states: {x: 0}\nequations: {x: floor(2*t)}\ntime: {end: 2}\n");
  const std::vector<long double> times = formula::switch_times(p, 2).times;
  ASSERT_EQ(times.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(static_cast<double>(times[k]), 0.5 * static_cast<double>(k + 1), 1e-15);
}

}  // namespace
}  // namespace odeum::conditions_test
