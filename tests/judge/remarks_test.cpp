// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/remarks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/text_case.hpp"

namespace odeum::remarks_test {
namespace {

Case of_text(const std::string& text) {
  return case_of(cases::text_statements("enzyme.yaml", text, "enzyme", {}).front());
}

const char* const enzyme =
    "states: {S: 1e-3, E: 1e-6, C: 0, P: 0}\n"
    "parameters: {k1: 1e6, km: 1e3, k2: 10}\n"
    "equations:\n"
    "  S: -k1*S*E + km*C\n"
    "  E: -k1*S*E + (km + k2)*C\n"
    "  C: k1*S*E - (km + k2)*C\n"
    "  P: k2*C\n"
    "time: {end: 1}\n";

/// The truth at the end, as a run to a tolerance that ended there.
struct Made {
  Request request;
  Outcome outcome;
  explicit Made(const Case& c) {
    request.mode = Mode::adaptive;
    set_tolerance(request, c, 1e-6);
    request.stops = {c.stops.back()};
    outcome.states.resize(c.y0.size());
    c.truth.at(c.stops.back(), outcome.states.data());
  }
};

TEST(LinearInvariants, AreThoseOfTheEquations) {
  using Sums = std::vector<std::vector<double>>;
  EXPECT_EQ(judge::linear_invariants(known_case("robertson")), (Sums{{1, 1, 1}}));
  Sums kept = judge::linear_invariants(of_text(enzyme));
  // Any two of S + C + P, E + C and S - E + P.
  ASSERT_EQ(kept.size(), 2U);
  for (const std::vector<double>& w : kept) {
    EXPECT_EQ(w[0], w[3]);
    EXPECT_EQ(w[2], w[0] + w[1]);
  }
  EXPECT_TRUE(judge::linear_invariants(known_case("lotka_volterra")).empty());
  EXPECT_TRUE(judge::linear_invariants(known_case("kepler_e06")).empty());
  // A velocity of -1.2e-16, where 0 is meant, made that of a state a sum which is kept.
  const Case turned = of_text(
      "states: {x: 1, v: sin(2*pi)}\nequations: {x: v, v: -4*x}\nscale: {x: 1, v: 1}\n"
      "time: {end: 1}\n");
  EXPECT_TRUE(judge::linear_invariants(turned).empty());
}

// A state that has been large between the start and the end of a run is not below its tolerance.
TEST(Remarks, LookAtTheTimesBetween) {
  const Case c = of_text(
      "states: {a: 1, b: 0, c: 0}\nequations: {a: -a, b: a - 2*b, c: 2*b}\n"
      "time: {end: 40, stops: [1, 40]}\n");
  const Made run(c);
  for (const std::string& said : judge::remarks(c, run.request, run.outcome))
    EXPECT_EQ(said.find("never exceed"), std::string::npos) << said;
}

TEST(Remarks, SayNothingOfAStateThatIsZero) {
  const Case c = of_text(
      "states: {x: 1, z: 0}\nequations: {x: -x, z: -z}\nscale: {x: 1, z: 1}\ntime: {end: 1}\n");
  const Made run(c);
  EXPECT_TRUE(judge::remarks(c, run.request, run.outcome).empty());
}

// Where the equations were looked at they keep v; the solution meets a wall beyond. Of a scene that
// bounces it was said that a run keeps no sum of velocities.
TEST(Remarks, SayNothingOfASumThatTheSolutionDoesNotKeep) {
  const Case c = of_text(
      "states: {x: 1, v: -1}\nequations: {x: v, v: \"100*max(0, 0.1 - x)\"}\ntime: {end: 2}\n");
  const Made run(c);
  ASSERT_EQ(judge::linear_invariants(c).size(), 1U);
  EXPECT_TRUE(judge::remarks(c, run.request, run.outcome).empty());
}

TEST(Remarks, SayWhatAnErrorAtTheEndHides) {
  const Case c = of_text(enzyme);
  Made run(c);
  EXPECT_TRUE(judge::remarks(c, run.request, run.outcome).empty());
  // One absolute tolerance for all, as solvers have by default.
  run.request.tolerance = Tolerance(1e-6, 1e-5);
  std::vector<std::string> said = judge::remarks(c, run.request, run.outcome);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(
      said[0],
      "E, C, P never exceed the absolute tolerance, which leaves the error uncontrolled there; "
      "--rtol 1e-06 --atol 1e-05,E=1e-12,C=5e-13,P=5e-12 controls it");
  set_tolerance(run.request, c, 1e-6);
  run.outcome.states[0] = -1.8e-6;
  said = judge::remarks(c, run.request, run.outcome);
  ASSERT_GE(said.size(), 2U);
  EXPECT_EQ(
      said[0],
      "S (-1.8e-06 at t = 1) falls below zero where the solution is not; --rtol 1e-06 --atol "
      "S=1e-11 asks for more digits, and --solver cvode/bdf --option constraints=1 takes no step "
      "below zero");
  EXPECT_NE(said[1].find("the equations keep "), std::string::npos) << said[1];
}

// The look along the solution tells its signs before, and without, a truth.
TEST(Remarks, KnowWhatIsBelowZeroWithoutATruth) {
  const Case c = case_before_truth(cases::text_statements("enzyme.yaml", enzyme, "enzyme").front());
  ASSERT_FALSE(c.truth.lowest.empty());
  Request request;
  request.mode = Mode::adaptive;
  set_tolerance(request, c, 1e-6);
  request.stops = {0.5, 1};
  Outcome outcome;
  outcome.states = {1e-4, -1e-9, 1e-9, 1e-6, 1e-4, 1e-9, -1e-8, 1e-6};
  const auto below = judge::below_zero(c, request, outcome);
  ASSERT_EQ(below.size(), 2U);
  EXPECT_EQ(below[0].component, 2U);  // a fiftieth of its size; the other is a thousandth
  EXPECT_EQ(below[0].value, -1e-8);
  EXPECT_EQ(below[0].time, 1);
  EXPECT_EQ(below[1].component, 1U);
  EXPECT_EQ(below[1].time, 0.5);
  const Case signs = case_before_truth(
      cases::text_statements(
          "signs.yaml", "states: {x: 1, v: 0}\nequations: {x: v, v: -x}\ntime: {end: 4}\n", "signs")
          .front());
  outcome.states = {-0.1, -0.1, -0.6, 0.7};
  EXPECT_TRUE(judge::below_zero(signs, request, outcome).empty());
}

}  // namespace
}  // namespace odeum::remarks_test
