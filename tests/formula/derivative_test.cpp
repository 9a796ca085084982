// SPDX-License-Identifier: BSD-3-Clause
// Derivatives and series of expressions, compiled and interpreted.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "odeum/formula/text_ode.hpp"
#include "support/problem_texts.hpp"

namespace odeum::derivative_test {
namespace {

using formula::TextOde;

/// Every function of the format, at points where it is smooth; x = 0.7, y = 1.3.
const char* const all_functions = R"(states: {x: 0.7, y: 1.3}
equations:
  x: sin(x*y) + cos(x)/y - tan(x)*asin(x/2) + acos(y/3)*atan(x) - atan2(x, y) + sinh(x)*cosh(y) + hypot(x, y)
  y: tanh(x - y) + exp(-x*t) + log(x + y)*log10(y) - sqrt(x)*abs(x - 5) + x^2.5/y^3 + x^y + y^0.3 + 2^x + min(x, y)*max(x, 2*y) + if(x < y, x*x, y) - x^20
time: {end: 1}
)";

TEST(Derivative, IsThatOfDifferences) {
  const TextOde ode(formula::read_problem("f", all_functions), TextOde::Code::interpreted);
  using Real = long double;
  const Real t = 0.4L, y[] = {0.7L, 1.3L};
  Real j[4];
  ode.jacobian_extended(t, y, j);
  // Central differences of h = 1e-6: the error is h^2 and 1e-19 / h.
  constexpr Real h = 1e-6L;
  for (int k = 0; k < 2; ++k) {
    Real up[] = {y[0], y[1]}, down[] = {y[0], y[1]}, f_up[2], f_down[2];
    up[k] += h;
    down[k] -= h;
    ode.rhs_extended(t, up, f_up);
    ode.rhs_extended(t, down, f_down);
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(static_cast<double>(j[2 * i + k]),
                  static_cast<double>((f_up[i] - f_down[i]) / (2 * h)), 1e-9)
          << i << k;
  }
  const double y_double[] = {0.7, 1.3};
  double dfdt[2];
  ode.view().time_derivative(ode.view().problem, 0.4, y_double, dfdt);
  EXPECT_EQ(dfdt[0], 0);
  EXPECT_NEAR(dfdt[1], -0.7 * std::exp(-0.28), 1e-15);
}

TEST(Derivative, OfManyNestedDefinitionsStaysSmall) {
  // Written out, a_60 has 2^60 terms.
  std::string text = "definitions:\n  a0: x + 1\n";
  for (int k = 1; k <= 60; ++k)
    text += "  a" + std::to_string(k) + ": 0.5*a" + std::to_string(k - 1) + "*a" +
            std::to_string(k - 1) + " + 0.1\n";
  text += "states: {x: 0.1}\nequations: {x: a60}\ntime: {end: 1}\n";
  const TextOde ode(formula::read_problem("f", text), TextOde::Code::interpreted);
  EXPECT_LT(ode.problem().graph.size(), 1000U);
}

TEST(Derivative, OfTooManyStatesIsRefusedWithTheNumberExpected) {
  formula::Problem problem = formula::read_problem(
      "f", "states: {x: 1, y: 1}\nequations: {x: x*y, y: x + y}\ntime: {end: 1}\n");
  try {
    formula::gradients(problem.graph, problem.equations, 2, 3);
    FAIL() << "no limit";
  } catch (const std::length_error& error) {
    EXPECT_NE(std::string(error.what()).find("got more than 3"), std::string::npos) << error.what();
  }
}

TEST(Derivative, CompiledAsInterpreted) {
  const TextOde compiled(formula::read_problem("f", all_functions));
  const TextOde interpreted(formula::read_problem("f", all_functions), TextOde::Code::interpreted);
  if (compiled.how().starts_with("interpreted")) GTEST_SKIP() << compiled.how();
  const double y[] = {0.7, 1.3};
  double a[4], b[4];
  // Multiply-adds and another library of functions: a few units in the last place of sums of terms
  // of size 10.
  const auto expect_near = [&](std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(a[k], b[k], 1e-13) << k;
  };
  compiled.rhs(0.4, y, a);
  interpreted.rhs(0.4, y, b);
  expect_near(2);
  compiled.view().jacobian(compiled.view().problem, 0.4, y, a);
  interpreted.view().jacobian(interpreted.view().problem, 0.4, y, b);
  expect_near(4);
  compiled.view().time_derivative(compiled.view().problem, 0.4, y, a);
  interpreted.view().time_derivative(interpreted.view().problem, 0.4, y, b);
  expect_near(2);
}

/// The solution through y by its series at a small distance, against many steps of the right-hand
/// side.
void expect_series(const TextOde& ode, double t, std::vector<double> y) {
  constexpr int order = 20;
  const std::size_t n = y.size();
  std::vector<double> c((order + 1) * n), f(n);
  ASSERT_NE(ode.view().taylor, nullptr);
  ode.view().taylor(ode.view().problem, t, y.data(), order, c.data());
  // The derivative of the series is the right-hand side along it.
  for (const double h : {0.01, 0.03}) {
    std::vector<double> at(n), slope(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = order + 1; k-- > 0;) {
        at[i] = at[i] * h + c[k * n + i];
        if (k > 0) slope[i] = slope[i] * h + static_cast<double>(k) * c[k * n + i];
      }
    ode.rhs(t + h, at.data(), f.data());
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(slope[i], f[i], 1e-12 * (1 + std::abs(f[i]))) << "h = " << h << ", " << i;
  }
}

TEST(Series, FulfilsTheEquations) {
  const char* const smooth = R"(states: {x: 0.7, y: 1.3}
equations:
  x: sin(x*y) + cos(x)/y - tan(x)*asin(x/2) + acos(y/3)*atan(x) - atan2(x, y) + sinh(x)*cosh(y) + hypot(x, y)
  y: tanh(x - y) + exp(-x*t) + log(x + y)*log10(y) - sqrt(x)*3 + x^2.5/y^3 + x^y + y^0.3 + 2^x
time: {end: 1}
)";
  for (const auto code : {TextOde::Code::compiled, TextOde::Code::interpreted})
    expect_series(TextOde(formula::read_problem("f", smooth), code), 0.4, {0.7, 1.3});
}

TEST(Structure, IsFound) {
  const auto structure = [](const std::string& text) {
    formula::Problem problem = formula::read_problem("f", text + "\ntime: {end: 1}\n");
    return formula::analyse(problem).structure;
  };
  auto s = structure("states: {q: 1, v: 0}\nequations: {q: v, v: -q}");
  EXPECT_TRUE(s.second_order && !s.velocity_dependent && s.linear && s.autonomous && s.smooth);
  EXPECT_EQ(s.entries, 2U);
  s = structure("states: {q: 1, v: 0}\nequations: {q: v, v: -q - 0.1*v + sin(t)}");
  EXPECT_TRUE(s.second_order && s.velocity_dependent && s.linear && !s.autonomous);
  // The sign of a velocity has no derivative: its acceleration was given no velocities, and read
  // them.
  s = structure("states: {q: 1, v: 0}\nequations: {q: v, v: -q - 0.2*sign(v)}");
  EXPECT_TRUE(s.second_order && s.velocity_dependent);
  // Coefficients may depend on t: Mathieu's equation, and one of first order.
  s = structure("states: {q: 1, v: 0}\nequations: {q: v, v: -(1 - 0.4*cos(2*t))*q}");
  EXPECT_TRUE(s.linear && !s.autonomous && s.second_order);
  s = structure("states: {f: 1}\nequations: {f: 4*(t-5)*f + 2*t^2 - 7}");
  EXPECT_TRUE(s.linear && !s.autonomous);
  s = structure("states: {f: 1}\nequations: {f: t*f^2}");
  EXPECT_FALSE(s.linear);
  s = structure("states: {v: 0, q: 1}\nequations: {q: v, v: -q^3}");
  EXPECT_TRUE(!s.second_order && s.second_order_in_other_order && !s.linear);
  s = structure("states: {x: 1, y: 1}\nequations: {x: abs(x), y: x}");
  EXPECT_TRUE(!s.smooth && !s.linear && !s.second_order);
  s = structure("parameters: {k: 0}\nstates: {x: 1}\nequations: {x: -x + k*x^2 + k*sin(t)}");
  EXPECT_TRUE(s.linear && s.autonomous) << "a term with the factor 0 is absent";
  s = structure(
      "states: {u[1..5]: 1}\nequations: {u[1..5]: u[i-1] - u[i]^2 + u[i+1]}\n"
      "boundaries: {u[0]: 0, u[6]: 0}");
  EXPECT_TRUE(s.lower == 1 && s.upper == 1 && s.entries == 13);
}

}  // namespace
}  // namespace odeum::derivative_test
