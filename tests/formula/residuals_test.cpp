// SPDX-License-Identifier: BSD-3-Clause
// Problems stated by residuals.
#include <gtest/gtest.h>

#include "odeum/cases/text_case.hpp"
#include "odeum/formula/reader.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum::formula::residuals_test {
namespace {

const std::string folder = ODEUM_SOURCE_DIR "/cases/problems/";

Problem problem_of(const std::string& stem) {
  const std::string file = folder + stem + ".yaml";
  return read_problem(file, problem_text(file));
}

std::vector<long double> slope_of(const Problem& p, long double t, std::vector<long double> y) {
  std::vector<long double> f(p.states.size());
  Evaluator<long double>(p.graph, p.equations)(t, y.data(), f.data());
  return f;
}

std::string error_of(const std::string& text) {
  try {
    read_problem("a.yaml", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string notes_of(const Problem& p) {
  std::string text;
  for (const auto& [name, note] : p.notes) text.append(name).append(": ").append(note).append("\n");
  return text;
}

TEST(Residuals, OfThirdOrderAreTheOrdinaryProblem) {
  const Problem p = problem_of("third_order_residual"), same = problem_of("third_order");
  EXPECT_EQ(p.states, (std::vector<std::string>{"f", "f'", "f''"}));
  EXPECT_NE(notes_of(p).find("solved for all rates: an ordinary problem"), std::string::npos);
  const std::vector<long double> y{1.5L, -0.25L, 0.75L};
  const auto found = slope_of(p, 1.25L, y), expected = slope_of(same, 1.25L, y);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(static_cast<double>(found[k]), static_cast<double>(expected[k]), 1e-15);
}

// A full matrix of rates: 2 x' + y' = t, x' - y' = x, of which x' = (t + x) / 3, y' = (t - 2 x)
// / 3.
TEST(Residuals, OfMixedRatesAreSolvedForEach) {
  const Problem p = read_problem(
      "a.yaml", "states: {x: 1, y: 2}\nresiduals: [2*x' + y' - t, x' - y' - x]\ntime: {end: 1}\n");
  const auto f = slope_of(p, 4, {1, 2});
  EXPECT_NEAR(static_cast<double>(f[0]), 5. / 3, 1e-16);
  EXPECT_NEAR(static_cast<double>(f[1]), 2. / 3, 1e-16);
}

TEST(Residuals, WithoutRatesAreConstraintsWhoseDerivativeGivesARate) {
  const Problem p = problem_of("robertson_constraint");
  EXPECT_NE(
      notes_of(p).find("residual 3: a constraint without rates, index 1; its derivative gives "
                       "z'"),
      std::string::npos)
      << notes_of(p);
  EXPECT_EQ(p.y0[2], 0) << "found from the constraint";
  const auto f = slope_of(p, 0, {0.9L, 1e-5L, 0.1L});
  EXPECT_NEAR(static_cast<double>(f[2]), 3e-3, 1e-16) << "3e7 y^2";
}

TEST(Residuals, OfRatesThatCannotBeIsolatedMakeThemStates) {
  const Problem p = problem_of("cubic_rate");
  ASSERT_EQ(p.states.size(), 2U);
  // r^3 + r = -1/2 by Cardano's formula.
  const long double root = std::sqrt(1 / 16.L + 1 / 27.L);
  const long double r = std::cbrt(-0.25L + root) + std::cbrt(-0.25L - root);
  EXPECT_NEAR(static_cast<double>(p.y0[1] - r), 0, 1e-17);
  EXPECT_NE(notes_of(p).find("cannot be solved for its rate"), std::string::npos) << notes_of(p);
}

TEST(Residuals, WithMistakesAreRefusedWithTheirPlace) {
  const std::string pendulum =
      "states: {x: 1, y: 0, u: 0, v: 0, lambda: 0}\nresiduals:\n  - x' - u\n  - y' - v\n"
      "  - u' + lambda*x\n  - v' + lambda*y + 9.81\n  - ";
  const std::string end = "\ntime: {end: 1}\n", two = "states: {x: 1, y: 0}\nresiduals:\n  - ";
  const std::pair<std::string, std::string> mistakes[] = {
      {pendulum + "x*u + y*v - 1" + end,
       "a.yaml:7:5: residuals: residual 5, a constraint, is not zero at the start; got -1"},
      {two + "x' + y" + end, "a.yaml:3:3: residuals: 1 short; got 1, expected 2"},
      {two + "x' + y\n  - z' - x" + end,
       "a.yaml:4:5: residuals: 2: no rate of a state; got z', expected that of a state"},
      {two + "x' + y\n  - x + y - 2" + end,
       "a.yaml:4:5: residuals: residual 2, a constraint, is not zero at the start; got -1"},
      {two + "x' + y\n  - x + y - 1\nrates: {x: 3}" + end,
       "a.yaml:5:12: rates: x: not what residual 1 says at the start; got 3, expected -0"},
      {two + "x' + y\n  - 2*x' + 2*y" + end, "a.yaml:4:5: residuals: residual 2: it has neither"},
      {two + "x' + y\n  - y*y' - x" + end, "the factor of y' is 0 at the start"},
      {"states: {x: 1, y: 0}\nequations: {x: y', y: x}" + end,
       "a.yaml:2:16: equations: x: no rate of a state; got y'"},
      {"states: {x: 1, y': 0}\nresiduals: [x' + y]" + end,
       "a.yaml:1:16: states: the rate of an unknown state"},
      {"states: {x: ~, y: ~}\nresiduals: [x' + y, x + y - 1]" + end,
       "2 of unknown start; got 1 constraints on them"}};
  for (const auto& [text, sentence] : mistakes)
    EXPECT_EQ(error_of(text).find(sentence) == std::string::npos, false)
        << error_of(text) << "\nfor\n"
        << text;
}

/// The end state of the computed truth, by component, against what the test set prints.
void expect_printed(const std::string& stem, const std::vector<double>& printed, double units) {
  const std::string file = folder + stem + ".yaml";
  const Case c =
      case_of(cases::text_statements(file, read_text_file(file, "problem", 100'000), stem).front());
  std::vector<double> y(printed.size());
  ASSERT_TRUE(c.truth.at(c.stops.back(), y.data()));
  EXPECT_LT(c.truth.floor, 1e-12);
  for (std::size_t k = 0; k < y.size(); ++k)
    EXPECT_NEAR(y[k], printed[k], units * std::abs(printed[k])) << k;
}

// Digits of the Test Set for IVP Solvers, computed there by PSIDE: to the last but rounding.
TEST(Residuals, ReachThePrintedDigitsOfAkzoNobel) {
  expect_printed("akzo_nobel",
                 {0.1150794920661702, 0.1203831471567715e-2, 0.1611562887407974,
                  0.3656156421249283e-3, 0.1708010885264404e-1, 0.4873531310307455e-2},
                 1e-15);
}
// There with a tolerance of 1e-14 a step, of which there are 16,000.
TEST(Residuals, ReachThePrintedDigitsOfTheTransistorAmplifier) {
  expect_printed(
      "transistor_amplifier",
      {-0.5562145012262709e-2, 0.3006522471903042e1, 0.2849958788608128e1, 0.2926422536206241e1,
       0.2704617865010554e1, 0.2761837778393145e1, 0.4770927631616772e1, 0.1236995868091548e1},
      1e-12);
}

}  // namespace
}  // namespace odeum::formula::residuals_test
