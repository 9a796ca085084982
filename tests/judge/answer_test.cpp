// SPDX-License-Identifier: BSD-3-Clause
// The verdict on the answer of a run to a tolerance, and the amplification that it rests on.
#include "odeum/judge/answer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "odeum/studies/convergence/pair_runs.hpp"
#include "support/catalogue.hpp"
#include "support/own_runs.hpp"

namespace odeum::tests::answer_test {
namespace {

using judge::Answer;

/// q'' = q from (1, -1): the solution e^-t (1, -1) decays, an error off it grows as e^t.
struct Saddle {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* f) const { f[0] = y[1], f[1] = y[0]; }
};

Case saddle_to(double horizon) {
  Contest<Saddle> contest;
  contest.problem = std::make_shared<const Saddle>();
  contest.y0 = std::make_shared<const std::vector<double>>(std::vector<double>{1, -1});
  Case c;
  c.id = "saddle";
  c.y0 = *contest.y0;
  c.stops = {horizon / 2, horizon};
  c.truth.at = [](double t, double* y) {
    y[0] = std::exp(-t), y[1] = -y[0];
    return true;
  };
  c.problem = erase(contest);
  return c;
}

TEST(Amplification, SeesWhatGrowsBesideADecayingSolution) {
  const Case c = saddle_to(8);
  const judge::Amplification found = judge::measure_amplification(c, c.stops);
  ASSERT_EQ(found.unknown, "");
  EXPECT_EQ(found.directions, 0U);
  for (std::size_t k = 0; k < c.stops.size(); ++k) {
    // The start amplifies most: the first row of Phi is (cosh t, sinh t), 1 + |y_i| = 2.
    const double expected = 2 * std::sqrt(2 * std::cosh(2 * c.stops[k]));
    EXPECT_NEAR(found.at_stops[k], expected, 1e-3 * expected) << "differences of 1e-6 to 1e-10";
  }
}

// Thresholds of a tolerance below which errors count absolutely, and the case's scales of
// components.
TEST(Amplification, IsThatOfTheToleranceAsked) {
  Case c = saddle_to(8);
  const auto start = [](double threshold, double t) {
    // The first row of Phi is (cosh t, sinh t), the state at the start (1, -1).
    return (threshold + 1) * std::sqrt(2 * std::cosh(2 * t));
  };
  const auto expect = [&](const judge::Amplification& found, double threshold, double scale) {
    ASSERT_EQ(found.unknown, "");
    for (std::size_t k = 0; k < c.stops.size(); ++k) {
      const double expected = start(threshold, c.stops[k]) / scale;
      EXPECT_NEAR(found.at_stops[k], expected, 1e-3 * expected) << threshold << ' ' << scale;
    }
  };
  const auto to = [&](double absolute) {
    return judge::measure_amplification(c, c.stops, Tolerance(1e-6, absolute));
  };
  expect(to(1e-6), 1, 1);
  expect(to(1e-12), 1e-6, 1);
  expect(to(1e-2), 1e4, 1);
  c.tolerance = Tolerance::of_thresholds(0, {1e-3, 1e-3});
  expect(judge::measure_amplification(c, c.stops), 1e-3, 1);
  c.units.scale = {10, 10};
  expect(judge::measure_amplification(c, c.stops), 1e-3, 10);
}

TEST(Amplification, IsUnknownWhereTheRunsMissTheTruth) {
  Case c = saddle_to(8);
  c.truth.at = [](double, double* y) {
    y[0] = y[1] = 0.5;
    return true;
  };
  const judge::Amplification found = judge::measure_amplification(c, c.stops);
  EXPECT_NE(found.unknown.find("from the truth"), std::string::npos) << found.unknown;
  const auto judged = judge::judge_answer({{.time = 4, .error_max = 1}}, found, 1e-6, 10, 0, 1);
  EXPECT_EQ(judged.answer, Answer::undetermined);
  EXPECT_EQ(judged.reason, "an error of the size of the solution, 1 at t = 4; " + found.unknown);
}

/// A rotation of 12,000 radians.
struct FastRotation {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* f) const { f[0] = 4000 * y[1], f[1] = -4000 * y[0]; }
};

// The explicit runs take more than 20,000 evaluations, the implicit ones more than a million.
TEST(Amplification, OfFastOscillationsIsMeasuredExplicitly) {
  Case c = saddle_to(3);
  Contest<FastRotation> contest;
  contest.problem = std::make_shared<const FastRotation>();
  c.y0 = {1, 0};
  contest.y0 = std::make_shared<const std::vector<double>>(c.y0);
  c.truth.at = [](double t, double* y) {
    y[0] = std::cos(4000 * t), y[1] = -std::sin(4000 * t);
    return true;
  };
  c.problem = erase(contest);
  const judge::Amplification found = judge::measure_amplification(c, c.stops);
  ASSERT_EQ(found.unknown, "");
  for (const double at : found.at_stops) {
    // The rows of Phi have norm 1, the units are 1 + |y_i|.
    EXPECT_GE(at, std::sqrt(2));
    EXPECT_LE(at, 2 * std::sqrt(2));
  }
}

// Random directions are followed for 726 unknowns: a cloth that swings neither damps errors much
// nor lets them explode within 2 s.
TEST(Amplification, OfManyUnknownsIsTakenFromRandomDirections) {
  const Case& c = find_case("cloth11_two_way");
  const judge::Amplification found = judge::measure_amplification(c, c.stops);
  ASSERT_EQ(found.unknown, "");
  EXPECT_GT(found.directions, 0U);
  const double last_step = std::sqrt(726.0);
  EXPECT_GE(found.at_stops.back(), last_step);
  EXPECT_LE(found.at_stops.back(), 1e4 * last_step);
  // Absolute tolerances ten and a thousand times as large: the states are of the size of 1. The
  // directions are few, and their components are weighted otherwise.
  const auto with = [&](double absolute) {
    return judge::measure_amplification(c, c.stops, Tolerance(1e-6, absolute)).at_stops.back();
  };
  EXPECT_NEAR(std::log10(with(1e-3) / with(1e-5)), 2, 0.15);
}

TEST(Answer, IsWrongBeyondWhatIsExplainedAndNeverBelow) {
  const judge::Amplification amplification{.at_stops = {2, 50}, .controls = {}, .unknown = {}};
  const auto judged = [&](double first, double second, double steps) {
    return judge::judge_answer({{.time = 1, .error_max = first}, {.time = 2, .error_max = second}},
                               amplification, 1e-6, steps, 1e-9, 1);
  };
  // 100 tolerances at least: 2e-4 at the first stop and 5e-3 at the second.
  EXPECT_EQ(judged(1.9e-4, 4.9e-3, 10).answer, Answer::explained);
  EXPECT_EQ(judged(1.9e-4, 4.9e-3, 10).reason, "");
  EXPECT_EQ(judged(2.3e-4, 4.9e-3, 10).answer, Answer::wrong) << "an early stop counts";
  EXPECT_EQ(judged(1.9e-4, 5.6e-3, 10).answer, Answer::wrong);
  EXPECT_EQ(judged(1.9e-4, 5.4e-3, 10).answer, Answer::undetermined) << "the bound is an estimate";
  EXPECT_NE(judged(1.9e-4, 5.4e-3, 10).reason.find("within 10 % of"), std::string::npos);
  EXPECT_EQ(judged(1.9e-4, 5.1e-3, 200).answer, Answer::explained) << "by the number of steps";
  EXPECT_NE(judged(1.9e-4, 5.6e-3, 10).reason.find("explain 0.005"), std::string::npos);
  const auto useless = judged(1e-9, 0.5, 20'000);
  EXPECT_EQ(useless.answer, Answer::explained);
  EXPECT_NE(useless.reason.find("size of the solution"), std::string::npos);
  EXPECT_EQ(judged(1e-9, std::nan(""), 10).answer, Answer::explained)
      << "by the stop that is known";
  EXPECT_EQ(judged(std::nan(""), std::nan(""), 10).answer, Answer::undetermined);
}

// The linear bound is 2.4 at a solution of 2: it explained an error of 1.6.
TEST(Answer, OfTheSizeOfTheSolutionIsExplainedByNoLinearBound) {
  const Case& c = find_case("vdp_eps1e_6");
  const judge::Judge judge(c, c.stops);
  const judge::Amplification found = judge::measure_amplification(c, c.stops);
  ASSERT_EQ(found.unknown, "");
  ASSERT_GE(found.controls.size(), 4U);
  const auto judged = [&](double error) {
    std::vector<judge::StopError> errors;
    for (const double stop : c.stops) errors.push_back({.time = stop, .error_max = 1e-9});
    errors.back().error_max = error;
    return judge::judge_answer(errors, found, 1e-4, 4000, c.truth.floor, judge.scale());
  };
  const double linear = 1e-4 * 4000 * found.at_stops.back();
  ASSERT_GT(linear, 1.6) << "else it tests nothing";
  EXPECT_EQ(judged(1.6).answer, Answer::wrong);
  EXPECT_NE(judged(1.6).reason.find("half of the solution"), std::string::npos);
  // What implicit Euler comes to there.
  EXPECT_EQ(judged(0.02).answer, Answer::explained);
}

// An error of one tolerance, 1e-4, grows to 33 beside the saddle, whatever a method of high order
// comes to.
TEST(Answer, OfTheSizeOfTheSolutionIsExplainedWhereOneStepMayLeadToIt) {
  const Case c = saddle_to(12);
  const judge::Judge judge(c, c.stops);
  const judge::Amplification found = judge::measure_amplification(c, c.stops);
  ASSERT_EQ(found.unknown, "");
  const auto judged =
      judge::judge_answer({{.time = 6, .error_max = 1e-3}, {.time = 12, .error_max = 2}}, found,
                          1e-4, 100, 0, judge.scale());
  EXPECT_EQ(judged.answer, Answer::explained);
  EXPECT_NE(judged.reason.find("size of the solution"), std::string::npos) << judged.reason;
}

/// The answers of a solver that meets `looser` times the tolerance that it is asked for.
std::vector<study::ConvergenceRow> rows_of(const Case& c, double looser) {
  Entrant entrant = find_entrant(c, "odeum/dormand_prince54");
  const auto solve = entrant.solve;
  entrant.solve = [solve, looser](Request request) {
    request.tolerance.relative *= looser;
    return solve(request);
  };
  const study::CaseMeasures measures{.gain = 1,
                                     .amplification = judge::measure_amplification(c, c.stops)};
  return study::converge_pair({&c, &entrant, Mode::adaptive}, measures, true).rows;
}

TEST(Answer, OfASolverThatIgnoresItsToleranceIsWrong) {
  for (const char* id : {"lotka_volterra", "rc_circuit", "kepler_e06", "henon_heiles_regular"}) {
    const Case& c = find_case(id);
    for (const auto& row : rows_of(c, 1))
      EXPECT_EQ(row.judged.answer, Answer::explained) << id << ' ' << row.judged.reason;
    int judged = 0;
    for (const auto& row : rows_of(c, 1e5)) {
      // A tolerance of more than 0.1 is none.
      if (row.setting > 1e-6 || row.status != "ok") continue;
      ++judged;
      EXPECT_EQ(row.judged.answer, Answer::wrong) << id << " at " << row.setting;
      EXPECT_NE(row.judged.reason, "");
    }
    EXPECT_GE(judged, 2) << id;
  }
}

}  // namespace
}  // namespace odeum::tests::answer_test
