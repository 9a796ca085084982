// SPDX-License-Identifier: BSD-3-Clause
// Equations with constraints of index 1 to 3, reduced by differentiation.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "odeum/cases/text_case.hpp"
#include "odeum/formula/reader.hpp"
#include "odeum/judge/constraint_drift.hpp"
#include "odeum/methods/rk4.hpp"
#include "support/catalogue.hpp"

namespace odeum::formula::constraints_test {
namespace {

// In Cartesian coordinates, from the horizontal: of index 3.
const std::string pendulum =
    "parameters: {g: 9.81}\n"
    "states: {x: 1, y: 0, u: 0, v: 0, lambda: ~}\n"
    "equations: {x: u, y: v, u: -lambda*x, v: -lambda*y - g}\n"
    "constraints:\n  - x^2 + y^2 - 1\n"
    "time: {end: 5}\n";

std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

Case case_of(const std::string& text) {
  return odeum::case_of(cases::text_statements("a.yaml", text, "a").front());
}

std::string error_of(const std::string& text) {
  try {
    read_problem("a.yaml", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<double> slope_of(const Problem& p, long double t, const std::vector<long double>& y) {
  std::vector<long double> f(p.states.size());
  Evaluator<long double>(p.graph, p.equations)(t, y.data(), f.data());
  return {f.begin(), f.end()};
}

std::string notes_of(const Problem& p) {
  std::string text;
  for (const auto& [name, note] : p.notes) text.append(name).append(": ").append(note).append("\n");
  return text;
}

// Three derivatives of the length give lambda' = -3 g v, where those before are zero.
TEST(Constraints, OfIndexThreeAreDifferentiatedThreeTimes) {
  const Problem p = read_problem("a.yaml", pendulum);
  EXPECT_EQ(p.index, 3);
  EXPECT_EQ(p.indices, (std::vector<int>{1, 1, 2, 2, 3}));
  ASSERT_EQ(p.constraints.size(), 3U);
  EXPECT_EQ(p.constraints[0].name, "constraint 1");
  EXPECT_EQ(p.constraints[2].name, "constraint 1, differentiated twice");
  const std::string notes = notes_of(p);
  for (const char* said :
       {"index 3; its third derivative gives lambda'", "constraint 1, differentiated once: u*x*2",
        "index: 3: 1 constraint, of which 2 hidden ones follow", "lambda = 0, found"})
    EXPECT_NE(notes.find(said), std::string::npos) << said << "\nin\n" << notes;
  const auto f = slope_of(p, 0, {0.6L, -0.8L, 0.8L, 0.6L, 7});
  const double expected[] = {0.8, 0.6, -7 * 0.6, 7 * 0.8 - 9.81, -3 * 9.81 * 0.6};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(f[k], expected[k], 1e-14) << k;
}

TEST(Constraints, AreTheSameAmongResiduals) {
  const Problem p = read_problem("a.yaml", pendulum),
                same = read_problem(
                    "a.yaml",
                    "states: {x: 1, y: 0, u: 0, v: 0, lambda: 0}\nresiduals: [x' - u, y' - v, u' + "
                    "lambda*x, v' + lambda*y + 9.81, x^2 + y^2 - 1]\ntime: {end: 1}\n");
  EXPECT_EQ(same.index, 3);
  const std::vector<long double> y{0.5L, 0.25L, -2, 1, 3};
  const auto f = slope_of(p, 0, y), g = slope_of(same, 0, y);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(f[k], g[k], 1e-14) << k;
}

// 0 = x - sin t along x' = z - x: z = x + cos t, z' = x' - sin t.
TEST(Constraints, OfIndexTwoDependOnTime) {
  const Problem p = read_problem(
      "a.yaml",
      "states: {x: 0, z: ~}\nequations: {x: z - x}\nconstraints: [x - sin(t)]\ntime: {end: 1}\n");
  EXPECT_EQ(p.index, 2);
  EXPECT_EQ(p.y0[1], 1);
  const auto f = slope_of(p, 2, {std::sin(2.L), std::sin(2.L) + std::cos(2.L)});
  EXPECT_NEAR(f[1], std::cos(2.) - std::sin(2.), 1e-15);
}

// More hidden constraints than unknown starts: a place and a force follow from three of them.
TEST(Constraints, GiveStartsThatAreOverdetermined) {
  const Problem p = read_problem(
      "a.yaml", with(pendulum, "x: 1, y: 0, u: 0, v: 0", "x: ~, y: -0.6, u: 0.6, v: 0.8"));
  EXPECT_NEAR(static_cast<double>(p.y0[0]), 0.8, 1e-15);
  EXPECT_NEAR(static_cast<double>(p.y0[4]), 1 + 9.81 * 0.6, 1e-15);
}

TEST(Constraints, WithMistakesAreRefusedWithTheirPlace) {
  const std::string end = "\ntime: {end: 1}\n";
  const std::pair<std::string, std::string> mistakes[] = {
      {with(pendulum, "u: 0,", "u: 0.5,"),
       "a.yaml:5:5: constraints: constraint 1, differentiated once, a hidden constraint, u*x*2 + "
       "v*y*2, is not zero at the start; got 1, expected 0"},
      {with(pendulum, "~", "3"),
       "constraint 1, differentiated twice, a hidden constraint, u*u*2 + v*v*2 - "},
      {with(pendulum, "- 1", "+ 1"), "constraint 1, a constraint, is not zero at the start; got 2"},
      {with(pendulum, "x^2 + y^2 - 1", "3"), "constraint 1: it says that 0 = 3, whatever"},
      {with(pendulum, "x^2 + y^2 - 1", "t - 3"), "constraint 1: it has neither a rate nor a state"},
      {with(pendulum, "  - x^2", "  - x^2 + y^2 - 1\n  - x^2"),
       "a.yaml:5:3: constraints: got 2, expected 1: one for each state without an equation, "
       "lambda"},
      {with(with(with(pendulum, "~", "~, mu: ~"), "-lambda*x", "-lambda*x - mu*y"), "  - x^2",
            "  - 2*(x^2 + y^2 - 1)\n  - x^2"),
       "a.yaml:6:5: constraints: constraint 2: after 3 derivatives it says nothing new"},
      {with(with(with(pendulum, "~", "~, mu: ~"), "-lambda*x", "-lambda*x - mu*y"), "  - x^2",
            "  - x^2 + y^2 - 1\n  - x^2"),
       "a.yaml:6:5: constraints: constraint 2: written twice; got the expression of constraint 1"},
      {with(with(pendulum, "~", "~, mu: 0"), "  - x^2", "  - u\n  - x^2"),
       "a.yaml:2:45: states: one that nothing determines; got mu in none"},
      {"states: {a: 0, b: 0, c: 0, z: ~}\nequations: {a: b, b: c, c: z}\nconstraints: [a - "
       "sin(t)]" +
           end,
       "a.yaml:3:15: constraints: constraint 1: a constraint of an index above 3: it and 3 "
       "derivatives say nothing of z"},
      {with(pendulum, "time:", "mass: {u: {u: 1}}\ntime:"), "mass: beside constraints"},
      {with(pendulum, "time:", "residuals: [x]\ntime:"), "residuals"},
      {with(pendulum, "time:", "outputs: {hidden_drift: x}\ntime:"), "outputs: a column twice"}};
  for (const auto& [text, sentence] : mistakes)
    EXPECT_NE(error_of(text).find(sentence), std::string::npos) << error_of(text) << "\nexpected\n"
                                                                << sentence << "\nfor\n"
                                                                << text;
}

// The end by the elliptic functions of the angle, to 18 digits by mpmath.
TEST(Constraints, TruthHasTheDigitsOfTheAngle) {
  const Case c = case_of(pendulum);
  const double exact[] = {0.942305435043757337, -0.334754338414000581, -0.857904256885949073,
                          -2.41492865437048862, 9.85182017952403709};
  std::vector<double> y(5);
  ASSERT_TRUE(c.truth.at(5, y.data()));
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(y[k], exact[k], c.floor_of(k) + 1e-15) << k;
  EXPECT_LT(c.truth.floor, 1e-11) << "of lambda, which begins at zero";
}

struct Squeezer {
  static constexpr std::size_t dimension = dynamic;
  std::size_t size() const { return 27; }
  void rhs(double t, const double* y, double* f) const { (*values)(t, y, f); }
  const Evaluator<double>* values;
};

// Andrews' squeezer, whose six loops are differentiated three times, in 4000 steps of the classical
// method, which has some 1e-9 of the angles. Its printed ends are those of PSIDE.
TEST(Constraints, OfAndrewsSqueezerLeadToThePrintedAngles) {
  const std::string file = ODEUM_SOURCE_DIR "/tests/outside/testset/andrews_squeezer.yaml";
  const Problem p = read_problem(file, problem_text(file));
  EXPECT_EQ(p.index, 3);
  EXPECT_EQ(p.constraints.size(), 25U) << "13, and 12 hidden ones";
  EXPECT_NEAR(static_cast<double>(p.y0[14]), 14222.4439199541, 1e-9) << "printed, too";
  const Evaluator<double> rates(p.graph, p.equations);
  const Squeezer squeezer{&rates};
  methods::rk4::Stepper<Squeezer> stepper(squeezer);
  std::vector<double> y(p.y0.begin(), p.y0.end());
  constexpr int steps = 4000;
  for (int k = 0; k < steps; ++k) stepper.step(0.03 * k / steps, 0.03 / steps, y);
  const double printed[] = {15.81077119629904,  -15.75637105984298, 0.04082224013073101,
                            -0.534730116322695, 0.5244099658805304, 0.534730116322695,
                            1.048080741042263};
  for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(y[k], printed[k], 1e-7) << p.states[k];
}

Outcome run_of(const Case& c, const char* solver, Request request, bool projected) {
  if (projected) request.options["projection"] = 1;
  Outcome outcome = tests::find_entrant(c, solver).solve(request);
  EXPECT_EQ(outcome.status, Status::ok) << solver << ": " << outcome.detail;
  return outcome;
}

double error_of(const Case& c, const Outcome& outcome) {
  std::vector<double> exact(c.y0.size());
  EXPECT_TRUE(c.truth.at(outcome.t, exact.data()));
  double largest = 0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    largest = std::max(largest, std::abs(outcome.states.at(k) - exact[k]));
  return largest;
}

// Without projection the length drifts by the errors of the steps. With it all three constraints
// hold to rounding of their terms, of at most 30, and the error does not grow beyond a few times
// what it was.
TEST(Constraints, AreKeptByProjection) {
  const Case c = case_of(pendulum);
  for (const char* solver : {"odeum/dormand_prince54", "odeum/dormand_prince853", "odeum/rodas4",
                             "odeum/radau_iia5", "odeum/gragg_bulirsch_stoer"}) {
    SCOPED_TRACE(solver);
    const Request request = tests::adaptive_request(1e-6, {5});
    const Outcome alone = run_of(c, solver, request, false),
                  kept = run_of(c, solver, request, true);
    const auto drift = judge::drift_off_constraints(c, request, kept);
    EXPECT_GT(judge::drift_off_constraints(c, request, alone).given.size, 1e-9);
    EXPECT_LT(drift.given.size, 1e-14);
    EXPECT_LT(drift.hidden.size, 1e-12);
    EXPECT_LT(error_of(c, kept), 3 * error_of(c, alone));
    EXPECT_GT(kept.counters.products, kept.counters.steps - 1) << "iterations count";
  }
}

// Outputs between the ends of steps, which are interpolated, are moved too.
TEST(Constraints, AreKeptAtOutputs) {
  const Case c = case_of(pendulum);
  Request request = tests::adaptive_request(1e-6, {});
  for (int k = 1; k <= 100; ++k) request.stops.push_back(0.05 * k);
  request.over_stops = true;
  const Outcome kept = run_of(c, "odeum/dormand_prince54", request, true);
  ASSERT_EQ(kept.states.size(), 500U);
  EXPECT_LT(judge::drift_off_constraints(c, request, kept).given.size, 1e-14);
}

// A projected step has the order of the method (Geometric Numerical Integration, IV.4): three
// tenths are the distance that halvings leave.
TEST(Constraints, ProjectionKeepsTheOrder) {
  const Case c = case_of(pendulum);
  for (const auto& [solver, order, steps] :
       {std::tuple{"odeum/rk4", 4, 2000U}, {"odeum/radau_iia5", 5, 500U}}) {
    const double coarse = error_of(c, run_of(c, solver, tests::fixed_request(steps, {5}), true)),
                 fine = error_of(c, run_of(c, solver, tests::fixed_request(2 * steps, {5}), true));
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.3) << solver;
  }
}

TEST(Constraints, ProjectionIsAnOptionOfOneStepMethods) {
  const Case c = case_of(pendulum);
  EXPECT_TRUE(tests::find_entrant(c, "odeum/rk4").info.options.contains("projection"));
  for (const char* other : {"odeum/bdf_variable", "odeum/radau_iia5_residual"})
    EXPECT_FALSE(tests::find_entrant(c, other).info.options.contains("projection")) << other;
  Request request = tests::adaptive_request(1e-6, {5});
  request.options["projection"] = 2;
  EXPECT_EQ(tests::find_entrant(c, "odeum/rk4").solve(request).detail,
            "projection: got 2, expected 0 or 1");
}

TEST(Constraints, DriftIsAnOutput) {
  const Case c = case_of(pendulum);
  ASSERT_EQ(c.outputs.names, (std::vector<std::string>{"constraint_drift", "hidden_drift"}));
  const double y[] = {1.5, 0, 0, 2, 1};
  double drift[2];
  c.outputs.at(0, y, drift);
  EXPECT_EQ(drift[0], 1.25);
  EXPECT_EQ(drift[1], 3.5) << "2 (v^2 - lambda x^2), of which u x + v y is 0";
}

}  // namespace
}  // namespace odeum::formula::constraints_test
