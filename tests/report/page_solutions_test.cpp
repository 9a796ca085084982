// SPDX-License-Identifier: BSD-3-Clause
// Solutions that the report draws beside the exact ones.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "odeum/cases/catalogue.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/studies/runner.hpp"
#include "odeum/trajectories/solutions.hpp"

namespace odeum::trajectories::page_solutions_test {
namespace {

CaseRun run_of(const Case& c, const std::string& solver, std::uint64_t steps) {
  const double end = c.stops.back();
  CaseRun run{.entrant = &study::find_solver(c.entrants, solver),
              .request = drawn_request(c, Mode::fixed, (end - c.t0) / static_cast<double>(steps),
                                       end, {.evaluations = 10'000, .seconds = 2}),
              .outcome = {}};
  run.outcome = run.entrant->solve(run.request);
  return run;
}

CaseRun adaptive_run_of(const Case& c, const std::string& solver, double tolerance) {
  CaseRun run{.entrant = &study::find_solver(c.entrants, solver),
              .request = drawn_request(c, Mode::adaptive, tolerance, c.stops.back(),
                                       {.evaluations = 10'000, .seconds = 2}),
              .outcome = {}};
  run.outcome = run.entrant->solve(run.request);
  return run;
}

TEST(PageSolutions, OutputsAreOnStepsAndEndAtTheHorizon) {
  const Case& c = known_case("kepler_e09");
  for (const std::uint64_t steps : {1, 7, 99, 100, 101, 320, 1777}) {
    const Request request = run_of(c, "odeum/rk4", steps).request;
    EXPECT_EQ(request.steps, steps);
    EXPECT_NO_THROW(require_sound(request, c.t0, c.y0.size())) << steps;
    EXPECT_TRUE(FixedGrid(c.t0, request).fits()) << steps;
    EXPECT_LE(request.stops.size(), 100U);
    EXPECT_GE(request.stops.size(), std::min<std::uint64_t>(steps, 50));
    EXPECT_EQ(request.stops.back(), c.stops.back());
  }
}

// Kepler's equation, solved by Newton's method: e = 0.9, semi-major axis and mass 1, from the
// pericentre.
TEST(PageSolutions, AComputedExactCurveIsExact) {
  const Case& c = known_case("kepler_e09");
  const ExactStates exact = exact_curve(c, {0.25, 2, 5.5, 9.75});
  ASSERT_TRUE(exact.everywhere);
  EXPECT_LT(exact.floor, 1e-10);
  for (const double t : {0.25, 2.0, 5.5, 9.75}) {
    double anomaly = t;
    for (int i = 0; i < 100; ++i)
      anomaly -= (anomaly - 0.9 * std::sin(anomaly) - t) / (1 - 0.9 * std::cos(anomaly));
    ASSERT_TRUE(exact.states.contains(t));
    const std::vector<double>& y = exact.states.at(t);
    // Rounding of the right-hand side, which e = 0.9 amplifies by some 1e3 in a period.
    EXPECT_NEAR(y[0], std::cos(anomaly) - 0.9, 1e-10) << t;
    EXPECT_NEAR(y[1], std::sqrt(1 - 0.81) * std::sin(anomaly), 1e-10) << t;
  }
  EXPECT_FALSE(exact.states.contains(0.3));
}

TEST(PageSolutions, OfALargeProblemTheTruthIsDrawnWhereItIsKnown) {
  const Case& c = known_case("cloth11_two_way");
  const ExactStates exact = exact_curve(c, {0.1, 0.25, 0.3, 1});
  EXPECT_FALSE(exact.everywhere);
  EXPECT_EQ(exact.states.size(), 2U);
  EXPECT_TRUE(exact.states.contains(0.25) && exact.states.contains(1));
  const auto drawn = drawn_components(c);
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_EQ(drawn[1], c.y0.size() / 2 + drawn[0]);
}

// The run for it took minutes, and was thrown away.
TEST(PageSolutions, ATruthOfFewDigitsChecksNoCurve) {
  Case c = known_case("kepler_e09");
  const auto at = c.truth.at;
  c.truth.at = [at, &c](double t, double* y) { return t == c.stops.front() && at(t, y); };
  const OdeView inner = c.problem.view;
  static OdeView plain;
  static int evaluations;
  plain = inner;
  evaluations = 0;
  c.problem.view.problem = &plain;
  c.problem.view.rhs = [](const void* problem, double t, const double* y, double* f) {
    ++evaluations;
    const OdeView& view = *static_cast<const OdeView*>(problem);
    return view.rhs(view.problem, t, y, f);
  };
  c.truth.floor = 1e-4;
  EXPECT_FALSE(exact_curve(c, {0.25, 2}).everywhere);
  EXPECT_EQ(evaluations, 0);
  c.truth.floor = 1e-10;
  EXPECT_TRUE(exact_curve(c, {0.25, 2}).everywhere);
  EXPECT_GT(evaluations, 0);
}

// Truth at more times than there are outputs made a line of marks.
TEST(PageSolutions, ExactStatesAreALineOnlyWhereEachOutputHasOne) {
  const Case& c = known_case("cloth11_two_way");
  CaseRun run;
  run.request.stops = {0.3, c.stops.back()};
  const ExactStates exact = exact_states(c, {run});
  EXPECT_GT(exact.states.size(), 3U);
  EXPECT_FALSE(exact.everywhere);
  run.request.stops = {c.stops.back()};
  EXPECT_TRUE(exact_states(c, {run}).everywhere);
}

TEST(PageSolutions, CurvesAndErrorsAreThoseOfTheRun) {
  const Case& c = known_case("damped_oscillator_underdamped");
  const CaseRun run = run_of(c, "odeum/explicit_euler", 80), finer = run_of(c, "odeum/rk4", 80);
  const std::vector<double>& stops = run.request.stops;
  ASSERT_EQ(run.outcome.status, Status::ok);
  Solutions solutions(c, c.stops.back(), exact_curve(c, stops));
  solutions.add(run);
  solutions.add(finer);
  solutions.add(finer);
  const auto json = solutions.json();
  EXPECT_TRUE(json["exact"]["everywhere"]);
  EXPECT_EQ(json["curves"].size(), 2U) << "equal curves are kept once";
  const auto& found = json["runs"]["odeum/explicit_euler:fixed:80"];
  ASSERT_EQ(found[0], 80);
  const auto& curve = json["curves"][found[1].get<std::size_t>()];
  ASSERT_EQ(curve.size(), 160U);
  std::vector<double> y(2);
  for (std::size_t k = 0; k < 80; ++k) {
    double error = 0;
    ASSERT_TRUE(c.truth.at(stops[k], y.data()));
    for (std::size_t i = 0; i < 2; ++i) {
      const double low = json["low"][i], high = json["high"][i],
                   value = run.outcome.states[2 * k + i];
      // A curve beyond half a range from the exact one's is cut.
      const double shown = low + (high - low) * curve[2 * k + i].get<double>() / 1000;
      const double cut = std::clamp(value, 1.5 * low - 0.5 * high, 1.5 * high - 0.5 * low);
      EXPECT_NEAR(shown, cut, 0.51e-3 * (high - low));
      error = std::fmax(error, std::abs(value - y[i]));
    }
    // Half of a hundredth of a decade is 1.2 %.
    EXPECT_NEAR(std::pow(10, found[2][k].get<double>() / 100) / error, 1, 0.012);
  }
}

// The absolute tolerance was one for all components: another run than that of the row.
TEST(PageSolutions, ACurveIsTheRunOfItsRow) {
  const Case& c = known_case("robertson_40");
  const CaseRun drawn = adaptive_run_of(c, "odeum/radau_iia5", 1e-6);
  ASSERT_EQ(drawn.outcome.status, Status::ok);
  Request alone{.mode = Mode::adaptive, .stops = {c.stops.back()}};
  set_tolerance(alone, c, 1e-6);
  const Outcome row = drawn.entrant->solve(alone);
  const double* const end = drawn.outcome.states.data() + drawn.outcome.states.size() - 3;
  const double curve_error = judge::error_at(c, c.stops.back(), end),
               row_error = judge::error_at(c, c.stops.back(), row.states.data());
  // Dense output ends on the state of the last step, which is shorter with an output there.
  EXPECT_LT(std::abs(std::log10(curve_error / row_error)), 0.3);
}

// Two tolerances of one decade had one curve, that of the last.
TEST(PageSolutions, EachToleranceHasItsCurve) {
  const Case& c = known_case("kepler_e09");
  Solutions solutions(c, c.stops.back(), exact_curve(c, {c.stops.back()}));
  solutions.add(adaptive_run_of(c, "odeum/dormand_prince54", 1e-3));
  solutions.add(adaptive_run_of(c, "odeum/dormand_prince54", 0.00042));
  const auto json = solutions.json();
  // Math.round(-1e6 * Math.log10(0.00042)), as the page computes it.
  EXPECT_TRUE(json["runs"].contains("odeum/dormand_prince54:adaptive:3376751"));
  EXPECT_TRUE(json["runs"].contains("odeum/dormand_prince54:adaptive:3000000"));
}

}  // namespace
}  // namespace odeum::trajectories::page_solutions_test
