// SPDX-License-Identifier: BSD-3-Clause
// Derivatives where an operation has none or an infinite one: at powers and roots of 0, in branches
// that are not taken, at kinks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>

#include "odeum/cases/text_case.hpp"
#include "odeum/formula/interval.hpp"
#include "odeum/formula/text_ode.hpp"
#include "support/catalogue.hpp"

namespace odeum::finite_derivatives_test {
namespace {

using formula::TextOde;

std::string text_of(const std::string& equation, double x, double y) {
  return fmt::format(
      "states: {{x: {}, y: {}}}\nequations: {{x: \"{}\", y: 1 + t}}\ntime: {{end: 2}}\n", x, y,
      equation);
}

/// df/dx and df/dy of an expression at a place, y moving up and x by the expression's sign.
struct Entry {
  const char* equation;
  double x, y, by_x, by_y;
};
const Entry entries[] = {
    {"1 + x^2.5", 0, 1, 0, 0},
    {"x^2.5/(0.5^2.5 + x^2.5)", 0, 1, 0, 0},
    {"1 - x^1.7/(1 + x^1.7)", 0, 1, 0, 0},
    {"1 + x*sqrt(x)", 0, 1, 0, 0},
    {"1 + y*sqrt(x)", 0, 0, 0, 0},
    {"1 + x^y", 0, 2, 0, 0},
    {"1 + x^y", 0, 1, 1, 0},
    {"1 - x^20", 0, 1, 0, 0},
    {"if(x > 0, sqrt(x), 1)", -1, 1, 0, 0},
    {"if(x > 0, x*log(x), y)", 0, 1, 0, 1},
    {"if(x == 0, y, sin(x)/x)", 0, 1, 0, 1},
    {"if(x < 0, 1/x, 2*x)", 0, 1, 2, 0},
    {"y - sqrt(max(x, 0))", -1, 1, 0, 1},
    {"y - 3*max(x - 2, 0)^0.6", 1, 1, 0, 1},
    {"1 - min(0, sqrt(x))", 0, 1, 0, 0},
    {"abs(x)", 0, 1, 1, 0},
    {"abs(x - 2*y)", 0, 0, 1, -2},
    {"1 + sqrt(x^2)", 0, 1, 1, 0},
    {"-1 - sqrt(x^2)", 0, 1, 1, 0},  // x moves down
    {"1 + sqrt(x^4)", 0, 1, 0, 0},
    {"1 + x*hypot(x, y)", 0, 0, 0, 0},
    {"1 + sqrt(x^2 + y^2)", 0, 0, 1, 1},
    {"1 - acos(1 - x^2)^2", 0, 1, 0, 0},
    {"2 - exp(-1/x^2)", 0, 1, 0, 0},
    {"min(x, y)", 1, 1, 1, 0},
    {"max(x, y)", 1, 1, 1, 0},
};

/// All of them as one problem, so that it is compiled once: states x[k], y[k].
std::string text_of_all() {
  std::string states, equations;
  for (std::size_t k = 0; k < std::size(entries); ++k) {
    std::string equation = entries[k].equation;
    for (std::size_t at = 0; at < equation.size(); ++at)
      if ((equation[at] == 'x' || equation[at] == 'y') &&
          (at == 0 || !std::isalpha(equation[at - 1])) &&
          (at + 1 == equation.size() || !std::isalpha(equation[at + 1])))
        equation.insert(at + 1, std::to_string(k));
    states += fmt::format("  x{0}: {1}\n  y{0}: {2}\n", k, entries[k].x, entries[k].y);
    equations += fmt::format("  x{0}: \"{1}\"\n  y{0}: 1 + t\n", k, equation);
  }
  return fmt::format("states:\n{}equations:\n{}time: {{end: 2}}\n", states, equations);
}

class Entries : public ::testing::TestWithParam<TextOde::Code> {};

TEST_P(Entries, AreThoseOfTheSideToWhichTheStateMoves) {
  const TextOde ode(formula::read_problem("f", text_of_all()), GetParam());
  const std::size_t n = ode.size();
  const std::vector<long double>& y_extended = ode.problem().y0;
  const std::vector<double> y(y_extended.begin(), y_extended.end());
  std::vector<double> j(n * n);
  std::vector<long double> j_extended(n * n);
  ode.view().jacobian(ode.view().problem, 0, y.data(), j.data());
  ode.jacobian_extended(0, y_extended.data(), j_extended.data());
  // One-sided limits are taken at a distance of 4e-12: of x^1.5 the derivative there is 3e-6, and
  // that of acos(1 - x^2)^2, in which 1 - x^2 is rounded, is found by a difference.
  constexpr double near = 1e-5;
  for (std::size_t k = 0; k < std::size(entries); ++k) {
    SCOPED_TRACE(entries[k].equation);
    const std::size_t at = 2 * k * n + 2 * k;
    EXPECT_NEAR(j[at], entries[k].by_x, near);
    EXPECT_NEAR(j[at + 1], entries[k].by_y, near);
    EXPECT_NEAR(static_cast<double>(j_extended[at]), entries[k].by_x, near);
    EXPECT_NEAR(static_cast<double>(j_extended[at + 1]), entries[k].by_y, near);
  }
}
INSTANTIATE_TEST_SUITE_P(Both, Entries,
                         ::testing::Values(TextOde::Code::compiled, TextOde::Code::interpreted));

TEST(InfiniteDerivatives, AreDifferencesInsideOfTheDomain) {
  // A difference of sqrt(x) at 0 over d is 1 / sqrt(d), with d = 1.5e-11 for a state of size 1.
  const double d = std::sqrt(std::numeric_limits<double>::epsilon()) * 1e-3;
  for (const char* const equation : {"y - sqrt(x)", "-y - sqrt(x)"}) {
    const TextOde ode(formula::read_problem("f", text_of(equation, 0, 1)));
    const double y[] = {0, 1};
    double j[4];
    ode.view().jacobian(ode.view().problem, 0, y, j);
    // Below 0 there is no root: the other side is taken also where x moves down.
    EXPECT_NEAR(j[0] * std::sqrt(d), -1, 1e-6) << equation;
    EXPECT_TRUE(ode.analysis().structure.infinite_slopes);
  }
  // The time derivative of sqrt(t) at 0, over 1.5e-11 of a span of 1.
  const TextOde ode(
      formula::read_problem("f", "states: {x: 1}\nequations: {x: sqrt(t) - x}\ntime: {end: 1}\n"));
  const double x = 1;
  double dfdt = 0;
  ode.view().time_derivative(ode.view().problem, 0, &x, &dfdt);
  EXPECT_NEAR(dfdt * std::sqrt(d), 1, 1e-6);
}

TEST(InfiniteDerivatives, AreNotSaidOfLengths) {
  const auto says = [](const std::string& equation) {
    formula::Problem problem = formula::read_problem("f", text_of(equation, 1, 1));
    return formula::analyse(problem).structure.infinite_slopes;
  };
  EXPECT_FALSE(says("1/sqrt(x^2 + y^2)"));
  EXPECT_FALSE(says("x^2.5"));
  EXPECT_TRUE(says("x^0.3"));
  EXPECT_TRUE(says("sqrt(x - y)"));
}

/// What has no singular point computes as before: the functions of the compiled code themselves.
TEST(FiniteDerivatives, CostPolynomialsNothing) {
  formula::Problem polynomial = formula::read_problem("f", text_of("x*y - x^3/7", 1, 1)),
                   root = formula::read_problem("f", text_of("sqrt(x)", 1, 1));
  EXPECT_FALSE(formula::analyse(polynomial).structure.steep);
  EXPECT_TRUE(formula::analyse(root).structure.steep);
}

TEST(FiniteDerivatives, OfManyStatesTakeFewEvaluations) {
  // Neighbours only: the columns are moved in three groups.
  const TextOde ode(formula::read_problem(
      "f",
      "states: {u[1..30]: 0}\nequations: {u[1..30]: 1 + sqrt(u[i])*u[i+1] - 2*u[i]^1.5*u[i-1]}\n"
      "boundaries: {u[0]: 1, u[31]: 2}\ntime: {end: 1}\n"));
  std::vector<double> y(30, 0), values(ode.sparsity().entries());
  ASSERT_NE(ode.view().jacobian_entries, nullptr);
  ode.view().jacobian_entries(ode.view().problem, 0, y.data(), values.data());
  for (std::size_t k = 0; k + 2 < values.size(); ++k) EXPECT_NEAR(values[k], 0, 1e-5) << k;
  EXPECT_GT(values.back(), 1e4);  // 2 sqrt(u) beside the boundary
}

TEST(FiniteDerivatives, OfIntervalsHoldThoseOfEveryPoint) {
  for (const Entry& each : entries) {
    formula::Problem problem = formula::read_problem("f", text_of(each.equation, each.x, each.y));
    const auto rows = formula::gradients(problem.graph, problem.equations, 2);
    std::vector<formula::Id> roots;
    std::vector<double> expected;
    for (const formula::Entry& entry : rows[0])
      if (entry.by < 2) {
        roots.push_back(entry.value);
        expected.push_back(entry.by == 0 ? each.by_x : each.by_y);
      }
    formula::Enclosure enclosure(problem.graph, roots);
    formula::Intervals t, x, y;
    t.fill({0, 1});
    x.fill({each.x - 0.25, each.x + 0.25});
    y.fill({each.y - 0.25, each.y + 0.25});
    const auto& values = enclosure(t, {x, y});
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const formula::Interval& v = values[enclosure.place(k)][0];
      EXPECT_TRUE(v.low <= expected[k] && v.high >= expected[k])
          << each.equation << ": " << v.low << " to " << v.high << ", " << expected[k];
    }
  }
}

TEST(SeriesAtZero, IsThatOfZeroWhereTheStateStaysZero) {
  // x stays 0; y' = 1 - y has the coefficients (-1)^(k+1) / k!.
  for (const auto code : {TextOde::Code::compiled, TextOde::Code::interpreted}) {
    const TextOde ode(
        formula::read_problem("f",
                              "states: {x: 0, y: 0}\ntime: {end: 1}\nequations:\n"
                              "  x: -x^2.5 - x^1.7 - sqrt(x)*y - x^20\n  y: 1 - y + x^0.3\n"),
        code);
    constexpr int order = 6;
    const double y[] = {0, 0};
    double c[2 * (order + 1)];
    ode.view().taylor(ode.view().problem, 0, y, order, c);
    double factorial = 1;
    for (int k = 1; k <= order; ++k) {
      factorial *= k;
      EXPECT_EQ(c[2 * k], 0) << k;
      EXPECT_NEAR(c[2 * k + 1] * factorial, k % 2 ? 1 : -1, 1e-15) << k;
    }
  }
}

/// Everything that uses derivatives or series.
const char* const solvers[] = {"radau_iia3",  "radau_iia5",    "radau_iia9",   "radau_iia_variable",
                               "gauss4",      "gauss6",        "sdirk2",       "sdirk3",
                               "sdirk4",      "lobatto_iiic4", "tr_bdf2",      "esdirk43",
                               "rodas4",      "rodas5p",       "ros2",         "ros3p",
                               "seulex",      "taylor",        "bdf_variable", "implicit_midpoint",
                               "trapezoidal", "implicit_euler"};

/// Published rate laws with a state that starts at 0, and ends by SciPy's Radau and LSODA at 1e-11.
struct RateLaw {
  const char* text;
  std::vector<double> end;
  std::string without = {};  ///< a method whose stages leave the domain at any step
};
const RateLaw rate_laws[] = {
    // Hill kinetics
    {"parameters: {V: 1, K: 0.5, h: 2.5, k: 0.3}\nstates: {s: 1, p: 0}\n"
     "equations: {s: -k*s, p: k*s - V*p^h/(K^h + p^h)}\ntime: {end: 10}\n",
     {0.04978707, 0.11737588}},
    // Two tanks that empty by Torricelli's law
    {"states: {a: 0, b: 0}\nequations: {a: 1 - sqrt(a), b: sqrt(a) - 0.7*sqrt(b)}\n"
     "time: {end: 6}\n",
     {0.96302696, 1.45282745},
     "lobatto_iiic4"},
    // A pair of genes that activate one another
    {"states: {x: 0, y: 0}\ntime: {end: 8}\nequations:\n"
     "  x: 0.5 + y^1.8/(1 + y^1.8) - x\n  y: 0.8*x^3.3/(1 + x^3.3) - 0.5*y\n",
     {0.53039365, 0.15789622}},
    // Runoff by Manning's law
    {"states: {h: 0}\nequations: {h: 0.3 - 2*h^(5/3)}\ntime: {end: 5}\n", {0.3201665}},
    // Drag of a body that falls from rest
    {"states: {x: 0, v: 0}\nequations: {x: v, v: 9.81 - 0.4*abs(v)^1.4*sign(v)}\n"
     "time: {end: 3}\n",
     {21.55453348, 9.63718715}},
    // Drag in a plane, by lengths
    {"states: {x: 0, y: 0, u: 0, v: 0}\ntime: {end: 5}\nequations:\n"
     "  {x: u, y: v, u: '1 - 0.5*u*sqrt(u^2 + v^2)', v: '0.5 - 0.5*v*hypot(u, v)'}\n",
     {5.44847606, 2.72423803, 1.33596718, 0.66798359}},
    // A weir
    {"states: {h: 0}\nequations: {h: '0.2 - 1.3*max(h - 0.5, 0)^1.5'}\ntime: {end: 10}\n",
     {0.78695762}},
    // Growth by von Bertalanffy's law
    {"states: {w: 1}\nequations: {w: 3*w^(2/3) - 0.5*w}\ntime: {end: 5}\n", {56.05036386}},
    {"states: {x: 0, y: 1}\nequations: {x: 1 - x*sqrt(x), y: x^y - y}\ntime: {end: 3}\n",
     {0.98452189, 0.91922318}}};

Case before_truth(const std::string& text) {
  return case_before_truth(cases::text_statements("f", text, "finite_derivatives").front());
}

TEST(SteepProblems, AreRunByEveryImplicitMethod) {
  for (const RateLaw& each : rate_laws) {
    const Case c = before_truth(each.text);
    for (const std::string id : solvers) {
      SCOPED_TRACE("odeum/" + id + " on " + c.equation);
      const Entrant& entrant = tests::find_entrant(c, "odeum/" + id);
      if (!entrant.solve || id == each.without) continue;  // taylor, where there are kinks
      const Outcome outcome = entrant.solve(tests::adaptive_request(1e-6, {c.end()}));
      EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
      if (outcome.status != Status::ok) continue;
      // Methods of first order leave some 1e3 times the tolerance, others some 10.
      for (std::size_t i = 0; i < each.end.size(); ++i)
        EXPECT_NEAR(outcome.states[i], each.end[i], 3e-3 * (1 + each.end[i]));
    }
  }
}

TEST(SteepProblems, AreRunByTaylorsMethodAtAFixedStep) {
  const Case c = before_truth(rate_laws[0].text);
  const Outcome outcome =
      tests::find_entrant(c, "odeum/taylor").solve(tests::fixed_request(400, {c.end()}));
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  // The first step is one of Heun's: (10/400)^3.
  EXPECT_NEAR(outcome.states[1], rate_laws[0].end[1], 2e-5);
}

}  // namespace
}  // namespace odeum::finite_derivatives_test
