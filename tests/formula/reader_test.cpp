// SPDX-License-Identifier: BSD-3-Clause
// Every mistake in a problem file has its place and what to do.
#include <gtest/gtest.h>

#include "support/problem_texts.hpp"

namespace odeum::reader_test {
namespace {

using tests::fault_of;
using tests::with_equation;

void expect_fault(const std::string& text, const std::string& begin, const std::string& part) {
  const std::string fault = fault_of(text);
  EXPECT_TRUE(fault.starts_with(begin) && fault.find(part) != std::string::npos)
      << "got       " << fault << "\nexpected  " << begin << " ... " << part << "\nof\n"
      << text.substr(0, 400);
}

TEST(ProblemReader, ReadsTheFormat) {
  const formula::Problem p = formula::read_problem("f", R"(name: Brusselator
parameters: {A: 1, B: 3}
definitions: {reaction: x^2*y}
states: {x: 1.01, y: A + 2}
equations:
  x: A + reaction - (B + 1)*x
  y: B*x - reaction
time: {end: 20, stops: [5, 10]}
scale: {y: 2}
tolerance: {relative: 1e-6, absolute: [1e-9, A*1e-12]}
)",
                                                   {{"B", "2.5"}});
  EXPECT_EQ(p.name, "Brusselator");
  EXPECT_EQ(p.states, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(p.y0[1], 3);
  EXPECT_EQ(p.stops, (std::vector<double>{5, 10, 20}));
  EXPECT_EQ(p.scale, (std::vector<double>{1, 2}));
  EXPECT_EQ(p.tolerance.relative, 1e-6);
  EXPECT_EQ(p.tolerance.absolutes(), (std::vector<double>{1e-9, 1e-12}));
  const double y[] = {2, 3};
  double f[2];
  formula::Evaluator<double>(p.graph, p.equations)(0, y, f);
  EXPECT_DOUBLE_EQ(f[0], 1 + 12 - 3.5 * 2);
  EXPECT_DOUBLE_EQ(f[1], 2.5 * 2 - 12);
}

TEST(ProblemReader, IndexedStatesInBracesAndInLines) {
  for (const char* text :
       {"states: {u[1..3]: i}\nequations: {u[1..3]: u[i-1] - 2*u[i] + u[i+1]}\n"
        "boundaries: {u[0]: 10, u[4]: t}\ntime: {end: 1}\n",
        "parameters: {n: 3}\nstates:\n  u[1..n]: i\nequations:\n  u[1]: 10 - 2*u[1] + u[2]\n"
        "  u[2..n]: u[i-1] - 2*u[i] + u[i+1]\nboundaries:\n  u[n+1]: t\ntime:\n  end: 1\n"}) {
    const formula::Problem p = formula::read_problem("f", text);
    ASSERT_EQ(p.states.size(), 3U) << text;
    EXPECT_EQ(p.states[2], "u[3]");
    const double y[] = {1, 2, 4};
    double f[3];
    formula::Evaluator<double>(p.graph, p.equations)(7, y, f);
    EXPECT_EQ(f[0], 10 - 2 + 2);
    EXPECT_EQ(f[1], 1 - 4 + 4);
    EXPECT_EQ(f[2], 2 - 8 + 7);
  }
}

double value_of(const std::string& expression) {
  const formula::Problem p = formula::read_problem("f", with_equation(expression));
  const double x = 1;
  double f = 0;
  formula::Evaluator<double>(p.graph, p.equations)(0, &x, &f);
  return f;
}

TEST(ProblemReader, OperatorsBindAsUsual) {
  EXPECT_EQ(value_of("2^3^2 + 0*x"), 512);
  EXPECT_EQ(value_of("-(x+1)^2"), -4);
  EXPECT_EQ(value_of("2*(x+1)^-1"), 1);
  EXPECT_EQ(value_of("8/4/2*x"), 1);
  EXPECT_EQ(value_of("8 - 4 - 2 - x"), 1);
  EXPECT_EQ(value_of("if(x >= 1, 5, 6)"), 5);
  EXPECT_EQ(value_of("if(x != 1, 5, 6)"), 6);
  EXPECT_EQ(value_of("if(x > 1, 1/(x - 1), 7)"), 7);
  EXPECT_EQ(value_of("min(x, 2) + max(x, 2) + abs(-x) + sign(-x)"), 3);
  EXPECT_EQ(value_of("1.5e1 + .5 - x"), 14.5);
  EXPECT_EQ(value_of("\"if(x < 2, 1, 0)\""), 1);
}

TEST(ProblemReader, NamesAndEquations) {
  expect_fault(with_equation("x + vv"), "3:10: equations: x: ", "unknown name; got vv");
  expect_fault("parameters: {speed: 1}\n" + with_equation("x*spede"),
               "4:8: ", "did you mean speed?");
  expect_fault("states: {x: 1, y: 2}\nequations: {x: y}\ntime: {end: 1}\n",
               "1:16: equations: missing", "none for y");
  expect_fault("states: {x: 1}\nequations: {x': 1}\ntime: {end: 1}\n",
               "2:13: equations: not a name", "got x', expected x: an equation's entry");
  expect_fault("states: {t: 1}\nequations: {t: 1}\ntime: {end: 1}\n", "1:10: states: ", "the time");
  expect_fault("states: {x: 1}\nequations: {x: 1, y: x}\ntime: {end: 1}\n",
               "2:19: equations: no state", "got y");
  expect_fault("states: {x: 1}\nequations: {x: 1, x: 2}\ntime: {end: 1}\n",
               "2:19: equations.x: duplicate key", "line 2");
  expect_fault("states: {x: 1}\nequation: {x: 1}\ntime: {end: 1}\n",
               "2:1: ", "did you mean equations?");
  expect_fault("states: {x: 1}\nequations: {x: 1}\n", "1:1: time: missing", "end: 20");
  expect_fault("parameters: {x: 1}\n" + with_equation("x"), "2:10: states: a name twice",
               "parameters");
  expect_fault("states: {2x: 1}\nequations: {2x: 1}\ntime: {end: 1}\n", "1:10: states: not a name",
               "2x");
  expect_fault("definitions: {a: b, b: 2*a}\n" + with_equation("a*x"),
               "1:18: definitions: a: ", "cyclic");
  expect_fault("definitions: {a: a + 1}\n" + with_equation("a*x"), "1:18: ", "cyclic");
  expect_fault("states: {x: y, y: 1}\nequations: {x: 1, y: 1}\ntime: {end: 1}\n", "1:13: states: x",
               "unknown name");
}

TEST(ProblemReader, Expressions) {
  expect_fault(with_equation("2x"), "3:7: ", "2*x, not 2x");
  expect_fault(with_equation("x y"), "3:8: ", "no operator");
  expect_fault(with_equation("(x + 1"), "3:12: ", "an open parenthesis");
  expect_fault(with_equation("x + 1)"), "3:11: ", "expected an operator");
  expect_fault(with_equation("x**2"), "3:7: ", "expected ^");
  expect_fault(with_equation("x +"), "3:9: ", "ends too early");
  expect_fault(with_equation("x, 3"), "3:7: ", "a decimal point");
  expect_fault(with_equation("x > 3"), "3:8: ", "if(condition, a, b)");
  expect_fault(with_equation("if(x, 1, 2)"), "3:10: ", "no comparison");
  expect_fault(with_equation("if(x = 1, 1, 2)"), "3:11: ", "==");
  expect_fault(with_equation("sin(x, 2)"), "3:6: ", "number of arguments of sin");
  expect_fault(with_equation("atan2(x)"), "3:6: ", "got 1, expected 2");
  expect_fault(with_equation("sni(x)"), "3:6: ", "did you mean sin?");
  expect_fault(with_equation("ln(x)"), "3:6: ", "got ln, expected log");
  expect_fault(with_equation("sin + x"), "3:6: ", "sin(...)");
  expect_fault(with_equation("1.2.3*x"), "3:9: ", "two decimal points");
  expect_fault(with_equation("x $ 2"), "3:8: ", "not understood");
  expect_fault(with_equation("`reboot`"), "3:6: ", "");
  expect_fault("states: {x: 1}\nequations: {x: min(x, 2)}\ntime: {end: 1}\n", "2:21: ", "quote");
  expect_fault(with_equation("x[1]"), "3:6: ", "x has no index");
}

TEST(ProblemReader, NumbersAndConstants) {
  expect_fault(with_equation("x/0"), "3:7: ", "division by zero");
  expect_fault(with_equation("1/(2 - 2) + x"), "3:7: ", "division by zero");
  expect_fault(with_equation("sqrt(-1)*x"), "3:6: ", "nan");
  expect_fault(with_equation("log(0)*x"), "3:6: ", "infinity");
  expect_fault(with_equation("9^9^9^9 + x"), "3:9: ", "too large");
  expect_fault(with_equation("1e999*x"), "3:6: ", "out of range");
  expect_fault(with_equation("1e-999*x"), "3:6: ", "out of range");
  expect_fault("parameters: {a: .nan}\n" + with_equation("a*x"), "1:17: parameters: a", "");
  expect_fault("parameters: {a: nan}\n" + with_equation("a*x"), "1:17: parameters: a",
               "unknown name");
  expect_fault("parameters: {a: \"0/0\"}\n" + with_equation("a*x"), "1:19: ", "division by zero");
  expect_fault(with_equation("1/(x - 1)"), "3:6: equations: x: not finite at the start",
               "division");
  expect_fault(with_equation("sqrt(x - 2)"), "3:6: equations: x: not finite at the start", "root");
  EXPECT_EQ(
      fault_of("parameters: {a: 1}\n" + with_equation("x/(a - 2)"), {{"a", "2"}}).substr(0, 5),
      "4:7: ");
  EXPECT_NE(fault_of(with_equation("x"), {{"b", "2"}}).find("--set b=2"), std::string::npos);
}

TEST(ProblemReader, TooMuch) {
  expect_fault(with_equation("x" + std::string(500'000, ' ') + std::string(500'000, '+') + "x"),
               "3:6: ", "too long");
  expect_fault(with_equation(std::string(10'000, '(') + "x" + std::string(10'000, ')')),
               "3:206: ", "nested too deeply");
  expect_fault(with_equation("x" +
                             [] {
                               std::string powers;
                               for (int k = 0; k < 10'000; ++k) powers += "^x";
                               return powers;
                             }()),
               "3:", "nested too deeply");
  expect_fault(with_equation(std::string(9'000, '-') + "x"), "3:", "nested too deeply");
  expect_fault("states: {u[1..200000]: 1}\nequations: {u[1..200000]: 1}\ntime: {end: 1}\n",
               "1:10: ", "too many");
  expect_fault("states: {u[1..1000000000]: 1}\nequations: {x: 1}\ntime: {end: 1}\n",
               "1:10: ", "too many");
  // A long sum is not nested deeply.
  std::string sum = "x";
  for (int k = 1; k < 9'000; ++k) sum += " + " + std::to_string(k) + "*x";
  EXPECT_EQ(fault_of(with_equation(sum)), "");
}

TEST(ProblemReader, TimesAndIndices) {
  const std::string problem = "states: {x: 1}\nequations: {x: x}\n";
  expect_fault(problem + "time: {end: 0}\n", "3:13: time: end", "after the start");
  expect_fault(problem + "time: {start: 2, end: 1}\n", "3:23: ", "more than 2");
  expect_fault(problem + "time: {end: 1, stops: [0.5, 2]}\n", "3:29: time: stops", "got 2");
  expect_fault(problem + "time: {end: 1, stops: [0.5, 0.5]}\n", "3:29: time: stops", "ascending");
  expect_fault(problem + "time: {end: 1, stops: 0.5}\n", "3:23: ", "a list of times");
  expect_fault(problem + "time: {ende: 1}\n", "3:8: ", "did you mean end?");
  const std::string chain = "states: {u[1..3]: 1}\ntime: {end: 1}\nequations: {u[1..3]: ";
  expect_fault(chain + "u[i+1]}\n",
               "3:22: ", "got u[4], expected 1 to 3, or a value for it in boundaries");
  expect_fault(chain + "u[i/2]}\n", "3:22: ", "must be a whole number");
  expect_fault(chain + "u}\n", "3:22: ", "no index");
  expect_fault("states: {u[1..3]: 1}\ntime: {end: 1}\nequations: {u[1..2]: 1}\n",
               "1:10: ", "none for u[3]");
  expect_fault("states: {u[1..3]: 1}\ntime: {end: 1}\nequations: {u[1..4]: 1}\n",
               "3:13: ", "out of range");
  expect_fault("states: {u[3..1]: 1}\ntime: {end: 1}\nequations: {u[1..3]: 1}\n",
               "1:10: ", "an empty range");
  expect_fault("states: {u[1..2,1..2]: 1}\ntime: {end: 1}\nequations: {x: 1}\n", "1:", "");
  expect_fault(chain + "1}\nboundaries: {u[2]: 0}\n", "4:14: boundaries: a state",
               "below 1 or above 3");
}

// Differences of neighbours on a fine mesh: the rounding of states near 1 is amplified by 1e8.
TEST(ProblemReader, TheRoundingOfAClosedFormOnAFineMeshIsNoFault) {
  const auto heat = [](const std::string& rate) {
    return "parameters: {n: 20000}\nstates: {u[1..n]: sin(pi*i/(n + 1))}\n"
           "equations: {u[1..n]: 0.1*(n + 1)^2*(u[i-1] - 2*u[i] + u[i+1])}\n"
           "boundaries: {u[0]: 0, u[n+1]: 0}\ntime: {end: 2}\n"
           "exact: {u[1..n]: sin(pi*i/(n + 1))*exp(-" +
           rate + "*0.1*(n + 1)^2*sin(pi/(2*(n + 1)))^2*t)}\n";
  };
  EXPECT_EQ(fault_of(heat("4")), "");
  expect_fault(heat("4.0001"), "6:22: exact: u[", "does not fulfil");
}

TEST(ProblemReader, ClosedFormsAndInvariantsAreChecked) {
  const std::string decay = "states: {x: 1}\nequations: {x: -2*x}\ntime: {end: 1}\n";
  EXPECT_EQ(fault_of(decay + "exact: {x: exp(-2*t)}\n"), "");
  expect_fault(decay + "exact: {x: exp(-2.0000001*t)}\n", "4:12: exact: x: does not fulfil",
               "derivative");
  expect_fault(decay + "exact: {x: 2*exp(-2*t)}\n", "4:12: exact: x: is not the initial value",
               "got 2");
  expect_fault(decay + "exact: {x: x}\n", "4:12: exact: x: ", "a closed form has no states");
  expect_fault(decay + "exact: {}\n", "1:10: exact: missing", "none for x");
  expect_fault(decay + "exact: {x: sqrt(1 - 2*t)}\n", "4:12: exact: x", "does not fulfil");
  const std::string oscillator =
      "states: {q: 1, v: 0.5}\nequations: {q: v, v: -q}\ntime: {end: 1}\n";
  EXPECT_EQ(fault_of(oscillator + "invariants: {H: q^2 + v^2}\n"), "");
  expect_fault(oscillator + "invariants: {H: q^2 + 2*v^2}\n", "4:17: invariants: H: changes",
               "expected 0");
  expect_fault(oscillator + "scale: {q: 0}\n", "4:12: scale: q", "positive");
  expect_fault(oscillator + "tolerance: {relative: -1}\n", "4:23: tolerance: relative", "positive");
  expect_fault(oscillator + "tolerance: {absolute: 1}\n", "4:12: tolerance", "no relative one");
  expect_fault(oscillator + "tolerance: {relative: 1e-3, absolute: [1, 2, 3]}\n",
               "4:39: tolerance: absolute", "got 3 numbers, expected one, or 2");
  expect_fault(oscillator + "tolerance: {relativ: 1}\n", "4:13: tolerance.relativ: an unknown key",
               "got relativ");
}

TEST(ProblemReader, FilesThatAreNone) {
  expect_fault("", "1:1: problem: ", "empty");
  expect_fault("- 1\n- 2\n", "1:1: problem: not a mapping", "");
  expect_fault("states: {x: 1\n", "", "problem: not YAML");
  expect_fault(std::string("states: \0", 9), "1:9: problem: ", "byte 0x00");
  expect_fault(with_equation("x") + "---\na: 1\n", "", "second document");
  expect_fault("states: &a {x: *a}\nequations: {x: 1}\ntime: {end: 1}\n", "", "");
  expect_fault("states: [1, 2]\nequations: {x: 1}\ntime: {end: 1}\n", "1:9: states: not a mapping",
               "");
  expect_fault("states: {x: {y: 1}}\nequations: {x: 1}\ntime: {end: 1}\n",
               "1:13: ", "not an expression");
  EXPECT_THROW(formula::problem_text("/"), InputError);
  EXPECT_THROW(formula::problem_text("/dev/null"), InputError);
}

}  // namespace
}  // namespace odeum::reader_test
