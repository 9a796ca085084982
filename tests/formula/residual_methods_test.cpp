// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/text_case.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/problem/implicit_form.hpp"
#include "support/catalogue.hpp"

namespace odeum::residual_methods_test {
namespace {

const char* const methods[] = {"odeum/radau_iia5_residual", "odeum/radau_iia9_residual"};
const char* const adaptive[] = {"odeum/radau_iia5_residual", "odeum/radau_iia9_residual",
                                "odeum/bdf_variable_residual", "odeum/rodas4_residual"};

Case case_of(const std::string& stem) {
  const std::string file = std::string(ODEUM_SOURCE_DIR "/cases/problems/") + stem + ".yaml";
  return odeum::case_of(
      cases::text_statements(file, read_text_file(file, "problem", 100'000), stem).front());
}

std::vector<double> end_of(const Case& c, const char* solver, const Request& request) {
  const Outcome outcome = tests::find_entrant(c, solver).solve(request);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
  EXPECT_GT(outcome.counters.rhs_evaluations, outcome.counters.steps);
  EXPECT_GT(outcome.counters.jacobian_evaluations, 0U);
  return outcome.states;
}

/// The largest error at the end, over what the tolerance of the requests is relative to: they have
/// the same number for a component and for its magnitude.
double error_of(const Case& c, const std::vector<double>& y) {
  std::vector<double> exact(c.y0.size());
  EXPECT_TRUE(c.truth.at(c.stops.back(), exact.data()));
  double largest = 0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    largest = std::max(largest, std::abs(y.at(k) - exact[k]) / (1 + std::abs(exact[k])));
  return largest;
}

// The pendulum's errors grow with time; those of the others stay near the tolerance, which bounds
// an estimate of a lower order.
TEST(ResidualMethods, ReachTheDigitsOfTheTestSet) {
  for (const char* id : {"akzo_nobel", "robertson_constraint", "cubic_rate", "transistor_amplifier",
                         "pendulum_xy"}) {
    const Case c = case_of(id);
    const double room = std::string(id) == "pendulum_xy" ? 100 : 1;
    for (const char* solver : adaptive)
      for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
        SCOPED_TRACE(std::string(id) + " " + solver + " " + std::to_string(tolerance));
        const Request request = tests::adaptive_request(tolerance, {c.stops.back()});
        EXPECT_LT(error_of(c, end_of(c, solver, request)), 3 * room * tolerance);
      }
  }
}

// Stiffly accurate: the end of a step is its last stage, which meets the residuals. In the ordinary
// problem of the same residuals the constraints drift by the errors of the steps.
TEST(ResidualMethods, KeepTheConstraints) {
  const auto drift = [](const Case& c, const char* solver) {
    const std::size_t n = c.y0.size();
    std::vector<double> y = end_of(c, solver, tests::adaptive_request(1e-6, {c.stops.back()})),
                        rates(n), r(n);
    c.problem.view.rhs(c.problem.view.problem, c.stops.back(), y.data(), rates.data());
    c.problem.implicit->residual(c.stops.back(), y.data(), rates.data(), r.data());
    return std::abs(r.back());
  };
  // Its last residual is the constraint, of terms of size 30. At this tolerance Newton's iteration
  // stops at some 1e-10 of them; the errors of the steps are 1e-6.
  const Case c = case_of("pendulum_xy");
  for (const char* solver : methods) EXPECT_LT(drift(c, solver), 1e-8) << solver;
  EXPECT_GT(drift(c, "odeum/radau_iia5"), 1e-7);
}

double order_of(const Case& c, const char* solver, std::uint64_t steps) {
  double errors[2];
  for (int k = 0; k < 2; ++k) {
    Request request;
    request.mode = Mode::fixed;
    request.steps = steps << k;
    request.stops = {c.stops.back()};
    errors[k] = error_of(c, end_of(c, solver, request));
  }
  return std::log2(errors[0] / errors[1]);
}

// Both have their full order in all components where the index is 1 (Solving ODEs II, theorem
// VI.1.1): a tenth is the distance that halvings at these steps leave. So have backward differences
// (theorem VI.2.1) and Rodas (VI.4).
TEST(ResidualMethods, HaveTheirOrderAtFixedSteps) {
  const Case c = case_of("pendulum_xy");
  EXPECT_NEAR(order_of(c, methods[0], 200), 5, 0.1);
  EXPECT_NEAR(order_of(c, methods[1], 40), 9, 0.1);
  EXPECT_NEAR(order_of(c, "odeum/bdf4_residual", 8000), 4, 0.1);
  EXPECT_NEAR(order_of(c, "odeum/rodas4_residual", 2000), 4, 0.1);
}

// Its constraints have exponentials of y / 0.026: rounded states move a stage by more than Newton's
// iteration leaves, which ended with newton_failed as soon as the second transistor conducted.
TEST(ResidualMethods, EndAtRoundingOfSteepConstraints) {
  const Case c = case_of("transistor_amplifier");
  for (const auto& [solver, bound] : {std::pair{methods[0], 1e-8}, {methods[1], 1e-12}}) {
    Request request;
    request.mode = Mode::fixed;
    request.steps = 2000;
    request.stops = {c.stops.back()};
    EXPECT_LT(error_of(c, end_of(c, solver, request)), bound) << solver;
  }
}

// y'^3 + y' = t - y: its residual depends on time, and the ordinary problem of its derivative does
// not. Without dR/dt Rosenbrock's method is of order 1 on it.
TEST(ResidualMethods, TakeTheTimeFromTheResiduals) {
  const Case c = case_of("cubic_rate");
  EXPECT_NEAR(order_of(c, "odeum/rodas4_residual", 160), 4, 0.1);
}

// A rate times a state: M depends on the state, and Rodas, which holds it constant within a step,
// would lose its order.
TEST(ResidualMethods, RosenbrockRefusesFactorsThatChange) {
  const std::string text =
      "name: m\nstates: {x: 1, z: 1}\nresiduals: [\"x*x' + x - z\", \"z^3 + z - "
      "2*x\"]\ntime: {end: 1}\n";
  const Case c = odeum::case_of(cases::text_statements("m.yaml", text, "m").front());
  const Outcome outcome =
      tests::find_entrant(c, "odeum/rodas4_residual").solve(tests::adaptive_request(1e-6, {1}));
  EXPECT_EQ(outcome.status, Status::refused);
  EXPECT_NE(outcome.detail.find("needs rates with constant factors"), std::string::npos);
  EXPECT_EQ(tests::find_entrant(c, "odeum/bdf_variable_residual")
                .solve(tests::adaptive_request(1e-6, {1}))
                .status,
            Status::ok);
}

Case pendulum_case(const std::string& constraint) {
  return odeum::case_of(
      cases::text_statements("a.yaml",
                             "states: {x: 1, y: 0, u: 0, v: 0, lambda: ~}\n"
                             "equations: {x: u, y: v, u: -lambda*x, v: -lambda*y - 9.81}\n"
                             "constraints: [" +
                                 constraint + "]\ntime: {end: 2}\n",
                             "a")
          .front());
}

// A multiplier has the order of the stages, S, where the index is 2, and S - 1 where it is 3
// (Solving ODEs II, theorems VII.4.5 and VII.4.9, table VII.4.1); it has the largest error.
TEST(ResidualMethods, HaveTheOrdersOfHigherIndices) {
  const Case two = pendulum_case("x*u + y*v"), three = pendulum_case("x^2 + y^2 - 1");
  EXPECT_NEAR(order_of(two, methods[0], 400), 3, 0.2);
  EXPECT_NEAR(order_of(two, methods[1], 100), 5, 0.3);
  EXPECT_NEAR(order_of(three, methods[0], 400), 2, 0.2);
  EXPECT_NEAR(order_of(three, methods[1], 100), 4, 0.3);
}

// To a tolerance the multiplier of index 3 has an error of its square root, about: the steps test
// it times h^2.
TEST(ResidualMethods, TakeConstraintsOfHigherIndexAsTheyAre) {
  for (const auto& [constraint, most] : {std::pair{"x*u + y*v", 1e-4}, {"x^2 + y^2 - 1", 1e-2}}) {
    const Case c = pendulum_case(constraint);
    for (const char* solver : {methods[0], methods[1], "odeum/bdf_variable_residual"}) {
      SCOPED_TRACE(std::string(solver) + " " + constraint);
      EXPECT_LT(error_of(c, end_of(c, solver, tests::adaptive_request(1e-6, {2}))), most);
    }
  }
  const Outcome outcome = tests::find_entrant(pendulum_case("x^2 + y^2 - 1"), adaptive[3])
                              .solve(tests::adaptive_request(1e-6, {2}));
  EXPECT_EQ(outcome.status, Status::refused) << outcome.detail;
}

// Stops between the ends of the steps change no step, and have errors of the same size: some
// tolerances, by Radau's methods below a tenth of it. The request has one absolute tolerance.
TEST(ResidualMethods, StepOverOutputs) {
  const Case c = case_of("akzo_nobel");
  for (const char* solver : adaptive) {
    SCOPED_TRACE(solver);
    const double room = std::string(solver).find("radau") == std::string::npos ? 3e-6 : 1e-7;
    const Entrant& entrant = tests::find_entrant(c, solver);
    Request request = tests::adaptive_request(1e-6, {c.stops.back()});
    request.record_steps = true;
    const Outcome alone = entrant.solve(request);
    request.over_stops = true;
    request.stops.clear();
    for (int k = 1; k <= 40; ++k) request.stops.push_back(c.stops.back() * k / 40);
    const Outcome outcome = entrant.solve(request);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_EQ(outcome.detail, "");
    EXPECT_EQ(outcome.step_ends, alone.step_ends);
    std::vector<double> exact(c.y0.size());
    for (std::size_t k = 0; k < 40; ++k) {
      if (!c.truth.at(request.stops[k], exact.data())) continue;
      for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(outcome.states[k * exact.size() + i], exact[i], room) << k;
    }
  }
}

TEST(ResidualMethods, NeedResidualsAndKeepTheBudget) {
  for (const char* solver : adaptive) {
    const Entrant& none = tests::find_entrant(tests::find_case("lotka_volterra"), solver);
    EXPECT_NE(none.unfit.find("needs residuals"), std::string::npos);
    const Case c = case_of("akzo_nobel");
    Request request = tests::adaptive_request(1e-9, {c.stops.back()});
    request.budget.evaluations = 50;
    const Outcome outcome = tests::find_entrant(c, solver).solve(request);
    EXPECT_EQ(outcome.status, Status::over_budget);
    EXPECT_LE(outcome.counters.rhs_evaluations, 50U);
  }
}

}  // namespace
}  // namespace odeum::residual_methods_test
