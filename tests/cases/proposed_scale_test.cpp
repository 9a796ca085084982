// SPDX-License-Identifier: BSD-3-Clause
// Units that Odeum proposes: the size of each component along the whole solution.
#include "odeum/cases/proposed_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/judge/remarks.hpp"

namespace odeum::proposed_scale_test {
namespace {

using Scale = std::vector<double>;

Case of_text(const std::string& text) {
  return case_of(cases::text_statements("proposed.yaml", text, "proposed", {}).front());
}

/// A run of an own method to a tolerance, with the units of the case.
struct Made {
  Request request;
  Outcome outcome;
  Made(const Case& c, const char* solver, double tolerance) {
    request.mode = Mode::adaptive;
    set_tolerance(request, c, tolerance);
    request.stops = {c.stops.back()};
    outcome = c.entrants.find(solver)->solve(request);
  }
};

const char* const enzyme =
    "states: {S: 1e-3, E: 1e-6, C: 0, P: 0}\n"
    "parameters: {k1: 1e6, km: 1e3, k2: 10}\n"
    "equations:\n"
    "  S: -k1*S*E + km*C\n"
    "  E: -k1*S*E + (km + k2)*C\n"
    "  C: k1*S*E - (km + k2)*C\n"
    "  P: k2*C\n"
    "time: {end: 1}\n";

TEST(ProposedScale, IsTheSizeOfEachState) {
  const Case c = of_text(enzyme);
  // C is 4.97e-7 at most, P 4.96e-6 at the end.
  EXPECT_EQ(c.units.scale, (Scale{1e-3, 1e-6, 5e-7, 5e-6}));
  EXPECT_EQ(c.tolerance.threshold(1), 1e-6);
  const auto stated = [](const std::string& more) { return of_text(enzyme + more).units.scale; };
  EXPECT_EQ(stated("scale: {S: 1, E: 1, C: 1, P: 1}\n"), (Scale{1, 1, 1, 1}));
  // The scale of the file is the unit of absolute tolerances as well.
  const Case given = of_text(std::string(enzyme) + "scale: {S: 1e-2, E: 1e-5, C: 1e-5, P: 1e-4}\n");
  EXPECT_EQ(given.tolerance.threshold(1), 1e-5);
  // A tolerance is not a unit of errors: a run to `advise --error 1e-3` was a step of Euler's
  // method.
  const Case tolerant =
      of_text(std::string(enzyme) + "tolerance: {relative: 1e-6, absolute: 1e-9}\n");
  EXPECT_EQ(tolerant.units.scale, c.units.scale);
  EXPECT_EQ(tolerant.tolerance.absolute(0), 1e-9);
  const Case exact = of_text(
      "states: {y: 1e-9}\nequations: {y: -1000*y}\nexact: {y: 1e-9*exp(-1000*t)}\n"
      "time: {end: 4e-3}\n");
  EXPECT_EQ(exact.units.scale, Scale{1e-9});
  EXPECT_LT(exact.truth.floor, 1e-14);
  // States near 1 stay in their own units.
  EXPECT_TRUE(
      of_text("states: {y: 2}\nequations: {y: -y^2}\ntime: {end: 3}\n").units.scale.empty());
}

// The truth's floor of chaos and of a growing mode, 6e-5 and 1.5e-6, made scales of 10000 and 1000.
TEST(ProposedScale, IsNotRaisedByTheFloorOfTheTruth) {
  EXPECT_TRUE(of_text("parameters: {s: 10, r: 28, b: 8/3}\nstates: {x: 3, y: 1, z: 1}\n"
                      "equations: {x: s*(y - x), y: x*(r - z) - y, z: x*y - b*z}\n"
                      "time: {end: 40}\n")
                  .units.scale.empty());
  const Case growing =
      of_text("states: {y: 1}\nequations: {y: 10*(y - cos(t)) - sin(t)}\ntime: {end: 3}\n");
  EXPECT_TRUE(growing.units.scale.empty());
  EXPECT_EQ(growing.truth.source.find("refuted"), std::string::npos) << growing.truth.source;
}

// Ten beads that touch at the start: which of them press each other there is in doubt, and the
// truth is not known. x of the third is 3.33722e-6 at most, by SciPy.
TEST(ProposedScale, IsKnownWhereBodiesTouchAtTheStart) {
  const Case c = of_text(
      "parameters: {A: 9.76e9, m: 4.05e-4}\n"
      "states: {\"x[1..10]\": 0, \"v[1..10]\": \"if(i < 2, 0.5, 0)\"}\n"
      "boundaries: {\"x[0]\": \"x[1]\", \"x[11]\": \"x[10]\"}\nequations:\n  x[1..10]: v[i]\n"
      "  v[1..10]: A/m*(max(x[i-1] - x[i], 0)^1.5 - max(x[i] - x[i+1], 0)^1.5)\n"
      "time: {end: 3e-4}\n");
  ASSERT_EQ(c.units.scale.size(), 20U);
  EXPECT_EQ(c.units.scale[2], 3e-6);
  EXPECT_EQ(c.units.scale[9], 1e-4);
  EXPECT_EQ(c.units.scale[10], 0.5);
}

// v is zero at the start and at all stops, and x zero at the start and at the end.
TEST(ProposedScale, LooksBetweenTheStops) {
  const Case periods =
      of_text("states: {x: 1, v: 0}\nequations: {x: v, v: -4*pi^2*x}\ntime: {end: 4}\n");
  EXPECT_TRUE(periods.units.scale.empty());
  const Made run(periods, "odeum/dormand_prince54", 1e-6);
  EXPECT_TRUE(judge::remarks(periods, run.request, run.outcome).empty());
  EXPECT_NEAR(judge::error_at(periods, 4, run.outcome.states.data()), 2e-5, 1e-5);
  const Case pulse = of_text(
      "states: {x: 0, s: 0}\nequations: {x: 1e7*pi*cos(pi*t), s: pi*sin(2*pi*t)}\n"
      "time: {end: 2, stops: [1, 2]}\n");
  EXPECT_EQ(pulse.units.scale[0], 1e7);
  EXPECT_GT(judge::Judge(pulse, pulse.stops).scale(), 0.5);
}

// y = 1/(1 - t), and the truth is known up to 0.5. A coarse run passed the pole, with y = 8e12, so
// that one step of Euler's method, which ends at 1.5, had an error of 6e-14.
TEST(ProposedScale, IsNotThatOfACoarseRunBeyondAPole) {
  const Case c = of_text("states: {y: 1}\nequations: {y: y^2}\ntime: {end: 2}\n");
  EXPECT_TRUE(c.units.scale.empty()) << c.units.scale[0];
}

TEST(ProposedScale, IsOfEachStateBesideFarLargerOnes) {
  const Case trace = of_text(
      "parameters: {k1: 1e-3, k2: 5}\nstates: {A: 55000, X: 0, Y: 0}\n"
      "equations: {A: -k1*1e-14*A, X: k1*1e-14*A - k2*X*(1 + sin(3*t)),"
      " Y: k2*X*(1 + sin(3*t))}\ntime: {end: 20}\n");
  EXPECT_EQ(trace.units.scale, (Scale{6e4, 4e-13, 1e-11}));
  std::vector<double> y(3);
  ASSERT_TRUE(trace.truth.at(20, y.data()));
  // Values of SciPy's Radau and DOP853 at a relative 1e-12 of each state.
  EXPECT_NEAR(y[1], 9.9576e-14, 1e-17);
  EXPECT_NEAR(y[2], 1.09004e-11, 1e-15);
  EXPECT_LT(trace.floor_of(1), 1e-10 * y[1]);
  EXPECT_LT(trace.truth.floor, 1e-10);
  const Case electron = of_text(
      "parameters: {q: 1.602176634e-19, m: 9.1093837e-31, E0: 1e9}\nstates: {x: 0, v: 0}\n"
      "equations: {x: v, v: q*E0/m}\ntime: {end: 1.61e-13}\n");
  EXPECT_EQ(electron.units.scale, (Scale{2e-6, 3e7}));
}

// 3.7 % of the bacteria, which is 1e-4 of those at the start.
TEST(ProposedScale, NamesAStateThatFallsAndRises) {
  const Case c = of_text(
      "parameters: {ke: 0.2, kg: 1.4, kd: 0.2, emax: 3, ec50: 10}\nstates: {B1: 100000, C: 100}\n"
      "definitions: {eff: emax*C/(ec50 + C)}\n"
      "equations: {B1: B1*kg - (kd + eff)*B1, C: -ke*C}\ntime: {end: 24}\n");
  ASSERT_TRUE(c.units.is_relative(0));
  EXPECT_FALSE(c.units.is_relative(1));
  EXPECT_LT(c.units.relative_from[0], 1);
  EXPECT_EQ(c.tolerance.threshold(0), c.units.relative_from[0]);
  std::vector<double> y(2);
  ASSERT_TRUE(c.truth.at(24, y.data()));
  EXPECT_NEAR(y[0], 252.3425, 1e-4);
  y[0] *= 1.037;
  EXPECT_NEAR(judge::error_at(c, 24, y.data()), 0.037, 1e-9);
  const std::string fact = c.facts.back().second;
  EXPECT_NE(fact.find("B1 (from "), std::string::npos) << fact;
  // Neither a state that crosses zero nor one that only falls.
  for (const char* other : {"states: {x: 1e4, v: 0}\nequations: {x: v, v: -x}\ntime: {end: 20}\n",
                            "states: {x: 1e4}\nequations: {x: -x}\ntime: {end: 20}\n"})
    EXPECT_TRUE(of_text(other).units.relative_from.empty()) << other;
}

// Values of 6e-246 and 1e-183, which no later one depends on, made tolerances relative to them:
// runs of 15,362 and 52,893 steps, and truths "known to 1.8e+228 up to t = 6.25".
TEST(ProposedScale, ForgetsADipFromWhichASourceLifts) {
  const Case rectifier =
      of_text("states: {v: 0}\nequations: {v: \"1e4*(max(sin(t), 0) - v)\"}\ntime: {end: 8}\n");
  EXPECT_TRUE(rectifier.units.relative_from.empty());
  double v = 0;
  ASSERT_TRUE(rectifier.truth.at(8, &v));
  EXPECT_NEAR(v, (1e8 * std::sin(8) - 1e4 * std::cos(8)) / (1e8 + 1), 1e-12);
  EXPECT_LT(rectifier.truth.floor, 1e-10);
  const std::string ozone =
      "parameters: {q1: 1.63e-16, q2: 4.66e-16, O2: 3.7e16, w: pi/43200}\n"
      "definitions: {s: sin(w*t), q3: \"if(s > 0, exp(-22.62/s), 0)\","
      " q4: \"if(s > 0, exp(-7.601/s), 0)\"}\nstates: {O: 1e6, O3: 1e12}\n"
      "equations: {O: -q1*O*O2 - q2*O*O3 + 2*q3*O2 + q4*O3, O3: q1*O*O2 - q2*O*O3 - q4*O3}\n"
      "time: {end: 172800}\n";
  const Case c = case_before_truth(cases::text_statements("ozone.yaml", ozone, "ozone").front());
  EXPECT_EQ(c.units.scale, (Scale{9e7, 1e12}));
  EXPECT_TRUE(c.units.relative_from.empty());
}

// A source lifts x at each dawn, by a switch: what is left of an error at night is nothing. Its
// rises were counted with the times of the switches, and x was taken for one that remembers.
TEST(ProposedScale, OfASourceThatSwitchesIsNotRelative) {
  const Case c = case_before_truth(
      cases::text_statements("dawn.yaml",
                             "states: {x: 0, s: 1}\nequations: {x: \"if(mod(t, 0.1) < 0.05, 1, "
                             "1e-12*exp(-t))*s - 1e3*x\", s: -s/1e3}\ntime: {end: 1}\n",
                             "dawn")
          .front());
  for (const double from : c.units.relative_from) EXPECT_EQ(from, 0);
  EXPECT_EQ(c.units.scale, (Scale{1e-3, 1}));
}

// A laser diode in SI units, which is switched on: the first step was below the rounding of t.
TEST(ProposedScale, HoldsFromASlopeThatIsSteepInItsUnits) {
  const Case c = of_text(
      "parameters: {q: 1.602176634e-19, V: 9e-17, tn: 3e-9, tp: 1e-12, g0: 3e-12, N0: 1.2e24}\n"
      "definitions: {I: \"if(t < 1e-10, 0, 0.05)\", gain: g0*(N - N0)*S/(1 + 3.4e-23*S)}\n"
      "states: {N: 0, S: 0}\nequations: {N: I/(q*V) - N/tn - gain, "
      "S: 0.44*gain - S/tp + 0.44*4e-4*N/tn}\ntime: {end: 5e-9}\n");
  EXPECT_EQ(c.units.scale, (Scale{2e24, 3e21}));
  std::vector<double> y(2);
  ASSERT_TRUE(c.truth.at(5e-9, y.data()));
  // SciPy's DOP853 gives these at a relative 1e-13.
  EXPECT_NEAR(y[0], 1.98928741823343e24, 1e11);
  EXPECT_NEAR(y[1], 1.23405676838916e21, 1e10);
}

// A size of 110 is 100 to one digit, which was taken for near enough to 1.
TEST(ProposedScale, BeginsBeyondAHundred) {
  const auto scale_of = [](const std::string& start) {
    return of_text("states: {x: " + start + "}\nequations: {x: -x}\ntime: {end: 2}\n").units.scale;
  };
  EXPECT_EQ(scale_of("110"), Scale{100});
  EXPECT_TRUE(scale_of("99").empty());
}

// x - y is 0, to rounding: such a state has no size of its own.
TEST(ProposedScale, KnowsRoundingFromATraceSpecies) {
  const Case c = of_text(
      "states: {x: 1000, y: 1000, d: 0, z: 0}\nequations: {x: -0.1*x, y: -y/10, d: 3*(x - y) - d, "
      "z: 0}\ntime: {end: 5}\n");
  EXPECT_EQ(c.units.scale, (Scale{1e3, 1e3, 1e3, 1e3}));
  // It was said of d that it never exceeds its tolerance, and that it falls below zero.
  const Made run(c, "odeum/dormand_prince54", 1e-6);
  for (const std::string& said : judge::remarks(c, run.request, run.outcome)) ADD_FAILURE() << said;
}

TEST(ProposedScale, IsKnownBeforeTheTruth) {
  const Case c = case_before_truth(cases::text_statements("enzyme.yaml", enzyme, "enzyme").front());
  EXPECT_EQ(c.units.scale, (Scale{1e-3, 1e-6, 5e-7, 5e-6}));
}

// A tag that an author writes is a word for people: "scene" made the errors of a text distances of
// particles, of which it has none, so that each was 0.
TEST(ErrorUnits, OfATextDoNotFollowFromItsTags) {
  const Case c = of_text(
      "states: {x: 1, y: 2}\nequations: {x: -x, y: -y}\ntime: {end: 1}\ncase: {tags: [scene]}\n");
  const std::vector<double> off{0.5, 0.75};
  std::vector<double> exact(2);
  ASSERT_TRUE(c.truth.at(1, exact.data()));
  EXPECT_NEAR(judge::error_of(c, off.data(), exact.data()), 0.5 - std::exp(-1.0), 1e-12);
  EXPECT_EQ(judge::unit_text(c), "absolute");
}

// What is left of a component that has decayed is the noise of a run, which rises and falls: its
// unit was 2e-23, and an error of 1e-14 of the whole was 4e7 of it.
TEST(ProposedScale, NoiseThatRisesIsNoSize) {
  const Case c =
      of_text("states: {a: 1, b: 0}\nequations: {a: -1000*a, b: 1000*a}\ntime: {end: 10}\n");
  EXPECT_TRUE(c.units.scale.empty());  // 1 of each
  EXPECT_EQ(c.tolerance.threshold(0), 1);
}

}  // namespace
}  // namespace odeum::proposed_scale_test
