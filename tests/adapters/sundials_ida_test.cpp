// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/text_case.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/measure/recording.hpp"
#include "odeum/problem/implicit_form.hpp"
#include "support/catalogue.hpp"

namespace odeum::sundials_ida_test {
namespace {

Case case_of(const std::string& stem) {
  const std::string file = std::string(ODEUM_SOURCE_DIR "/cases/problems/") + stem + ".yaml";
  return odeum::case_of(
      cases::text_statements(file, read_text_file(file, "problem", 100'000), stem).front());
}

/// The largest error at the end, over the scale of the component.
double error_at_end(const Case& c, double tolerance) {
  const Outcome outcome =
      tests::find_entrant(c, "ida/bdf").solve(tests::adaptive_request(tolerance, {c.stops.back()}));
  EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
  EXPECT_GT(outcome.counters.rhs_evaluations, outcome.counters.steps);
  EXPECT_GT(outcome.counters.jacobian_evaluations, 0U);
  std::vector<double> exact(c.y0.size());
  EXPECT_TRUE(c.truth.at(c.stops.back(), exact.data()));
  double largest = 0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    largest = std::max(largest, std::abs(outcome.states.at(k) - exact[k]) / c.scale_of(k));
  return largest;
}

// Errors of this size are some hundred times the tolerance, as of CVODE's method on such problems.
TEST(Ida, SolvesConstraintsAndRatesThatCannotBeIsolated) {
  for (const char* id : {"akzo_nobel", "robertson_constraint", "cubic_rate"}) {
    SCOPED_TRACE(id);
    const Case c = case_of(id);
    EXPECT_LT(error_at_end(c, 1e-6), 1e-4);
    EXPECT_LT(error_at_end(c, 1e-9), 1e-7);
  }
  EXPECT_LT(error_at_end(case_of("transistor_amplifier"), 1e-6), 1e-4);
}

// dR/dy + alpha dR/dy' against central differences along each state and its rate.
TEST(Ida, HasTheExactMatrixOfItsNewtonIteration) {
  for (const char* id : {"akzo_nobel", "transistor_amplifier", "pendulum_xy", "cubic_rate"}) {
    SCOPED_TRACE(id);
    const Case c = case_of(id);
    const ImplicitForm& form = *c.problem.implicit;
    const std::size_t n = form.dimension;
    const double t = 0.3, alpha = 7, step = 1e-6;
    std::vector<double> y = c.y0, rates(n, 0.5), matrix(n * n), above(n), below(n);
    for (double& value : y) value += 0.01;  // where every term has its part
    form.matrix(t, y.data(), rates.data(), alpha, matrix.data());
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<double> moved = y, moved_rates = rates;
      moved[j] += step, moved_rates[j] += alpha * step;
      form.residual(t, moved.data(), moved_rates.data(), above.data());
      moved[j] -= 2 * step, moved_rates[j] -= 2 * alpha * step;
      form.residual(t, moved.data(), moved_rates.data(), below.data());
      for (std::size_t i = 0; i < n; ++i) {
        const double slope = (above[i] - below[i]) / (2 * step), entry = matrix[i * n + j];
        // The tolerance covers the third derivatives, and rounding of the residual.
        EXPECT_NEAR(entry, slope, 1e-6 * std::abs(entry) + 1e-8) << i << " " << j;
      }
    }
  }
}

TEST(Ida, NeedsResidualsAndKeepsTheBudget) {
  const Entrant& none = tests::find_entrant(tests::find_case("lotka_volterra"), "ida/bdf");
  EXPECT_NE(none.unfit.find("needs residuals"), std::string::npos);
  const Case c = case_of("akzo_nobel");
  Request request = tests::adaptive_request(1e-9, {c.stops.back()});
  request.budget.evaluations = 50;
  const Outcome outcome = tests::find_entrant(c, "ida/bdf").solve(request);
  EXPECT_EQ(outcome.status, Status::over_budget) << outcome.detail;
  EXPECT_LT(outcome.t, c.stops.back());
  const Outcome fixed =
      tests::find_entrant(c, "ida/bdf").solve(tests::fixed_request(10, {c.stops.back()}));
  EXPECT_EQ(fixed.status, Status::refused);
}

// Its run is made again with the evaluations noted, which are those of the residuals.
TEST(Ida, TellsWhyItsStepsAreAsTheyAre) {
  const Case c = case_of("akzo_nobel");
  const measure::Run run =
      measure::record(c, "ida/bdf", tests::adaptive_request(1e-6, {c.stops.back()}), 4);
  EXPECT_TRUE(run.ok()) << run.outcome.detail;
  EXPECT_GT(run.trace.times.size(), run.steps());
  EXPECT_TRUE(run.exact);
}

// Multipliers have an error of their own, some tenfold, beside those that are tested.
TEST(Ida, TakesConstraintsOfIndexTwoAsTheyAre) {
  const Case c = odeum::case_of(
      cases::text_statements("a.yaml",
                             "states: {x: 1, y: 0, u: 0, v: 0, lambda: ~}\n"
                             "equations: {x: u, y: v, u: -lambda*x, v: -lambda*y - 9.81}\n"
                             "constraints: [x*u + y*v]\ntime: {end: 2}\n",
                             "a")
          .front());
  EXPECT_LT(error_at_end(c, 1e-6), 1e-3);
  EXPECT_LT(error_at_end(c, 1e-8), 1e-5);
}

}  // namespace
}  // namespace odeum::sundials_ida_test
