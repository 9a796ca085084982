// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "adapters/sundials_problems.hpp"

namespace odeum::sundials_tests::sundials_fault_test {
namespace {

/// y' = lambda y, lambda variable.
struct Decay {
  static constexpr std::size_t dimension = 1;
  double lambda = -1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = lambda * y[0]; }
  void jacobian(double, const double*, double* j) const { j[0] = lambda; }
};

TEST(SundialsRun, FixedStepTakesExactlyTheStepsAndReachesEveryStop) {
  for (const Entrant& entrant : entrants<Witch>({1, 0})) {
    if (!entrant.info.fixed) continue;
    // 30 steps of 0.1, which is not a binary fraction: sums of it do not end on the stops.
    const std::vector<double> stops{0.1, 1.7, 3};
    const Outcome outcome = entrant.solve(fixed(30, stops));
    ASSERT_EQ(outcome.status, Status::ok) << entrant.info.id() << ": " << outcome.detail;
    EXPECT_EQ(outcome.counters.steps, 30u) << entrant.info.id();
    EXPECT_EQ(outcome.counters.rejected_steps, 0u) << entrant.info.id();
    EXPECT_EQ(outcome.t, 3.0) << entrant.info.id();
    ASSERT_EQ(outcome.states.size(), 6u) << entrant.info.id();
    for (std::size_t stop = 0; stop < 3; ++stop)  // order 1 at h = 0.1 is off by some 0.05
      EXPECT_LT(Witch::error(stops[stop], outcome.states.data() + 2 * stop), 0.1)
          << entrant.info.id() << " at " << stops[stop];
  }
}

TEST(SundialsRun, EvaluationsAreThoseOfTheTable) {
  const auto list = entrants<Witch>({1, 0});
  const auto evaluations = [&](const char* id) {
    return find(list, id).solve(fixed(100, {1})).counters.rhs_evaluations;
  };
  // Seven stages: ERKStep reuses the last as the first, and evaluates the first of the run
  // separately.
  EXPECT_EQ(evaluations("arkode/erkstep_dormand_prince_7_4_5"), 601u);
  EXPECT_EQ(evaluations("arkode/erkstep_zonneveld_5_3_4"), 501u);
  // ARKStep reuses nothing, and evaluates once more at the start.
  EXPECT_EQ(evaluations("arkode/arkstep_dormand_prince_7_4_5"), 701u);
}

TEST(SundialsRun, AdaptiveLandsOnEveryStop) {
  for (const Entrant& entrant : entrants<Witch>({1, 0})) {
    if (!entrant.info.adaptive) continue;
    const std::vector<double> stops{0.1, 1.7, 3};
    const Outcome outcome = entrant.solve(adaptive(1e-5, stops));
    ASSERT_EQ(outcome.status, Status::ok) << entrant.info.id() << ": " << outcome.detail;
    EXPECT_EQ(outcome.t, 3.0) << entrant.info.id();
    EXPECT_GT(outcome.counters.steps, 3u) << entrant.info.id();
    ASSERT_EQ(outcome.states.size(), 6u) << entrant.info.id();
    for (std::size_t stop = 0; stop < 3; ++stop)  // a global error of some hundred tolerances
      EXPECT_LT(Witch::error(stops[stop], outcome.states.data() + 2 * stop), 5e-3)
          << entrant.info.id() << " at " << stops[stop];
  }
}

TEST(SundialsRun, RefusesTheModeThatASolverLacks) {
  for (const Entrant& entrant : entrants<Witch>({1, 0})) {
    if (!entrant.info.fixed) {
      const Outcome outcome = entrant.solve(fixed(10, {1}));
      EXPECT_EQ(outcome.status, Status::refused) << entrant.info.id();
      EXPECT_NE(outcome.detail, "");
    }
    if (!entrant.info.adaptive) {
      const Outcome outcome = entrant.solve(adaptive(1e-6, {1}));
      EXPECT_EQ(outcome.status, Status::refused) << entrant.info.id();
      EXPECT_NE(outcome.detail, "");
    }
  }
  const auto list = entrants<Witch>({1, 0});
  EXPECT_FALSE(find(list, "cvode/bdf").info.fixed);
  EXPECT_FALSE(find(list, "arkode/erkstep_knoth_wolke_3_3").info.adaptive);
}

TEST(SundialsFault, NanInTheRightHandSideIsReportedWithItsTimeAndQuietly) {
  const auto list = entrants<NanLater>({1});
  std::vector<Outcome> outcomes;
  outcomes.reserve(list.size());
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  for (const Entrant& entrant : list)
    outcomes.push_back(entrant.solve(any_request(entrant.info, {1})));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Outcome& outcome = outcomes[i];
    EXPECT_NE(outcome.status, Status::ok) << list[i].info.id() << ": " << outcome.detail;
    EXPECT_NE(outcome.detail.find("component 0"), std::string::npos) << outcome.detail;
    // The library's time is that of the stage that failed; steps are of some 0.1 at most.
    EXPECT_NEAR(outcome.t, 0.5, 0.1) << list[i].info.id();
  }
}

TEST(SundialsFault, BudgetOfEvaluationsIsKept) {
  for (const Entrant& entrant : entrants<Witch>({1, 0})) {
    Request request = any_request(entrant.info, {5});
    request.budget.evaluations = 20;
    const Outcome outcome = entrant.solve(request);
    EXPECT_EQ(outcome.status, Status::over_budget) << entrant.info.id() << ": " << outcome.detail;
    EXPECT_LE(outcome.counters.rhs_evaluations, 20u) << entrant.info.id();
  }
}

TEST(SundialsFault, PoleIsNotStepped) {
  for (const Entrant& entrant : entrants<Pole>({1})) {
    if (!entrant.info.adaptive) continue;
    Request request = adaptive(1e-4, {2});
    request.budget.evaluations = 1'000'000;
    const Outcome outcome = entrant.solve(request);
    EXPECT_TRUE(outcome.status == Status::step_too_small || outcome.status == Status::newton_failed)
        << entrant.info.id() << ": " << to_string(outcome.status) << ' ' << outcome.detail;
    EXPECT_NEAR(outcome.t, 1, 0.01) << entrant.info.id() << outcome.detail;
  }
  const auto list = entrants<Pole>({1});
  const Outcome outcome =
      find(list, "arkode/erkstep_dormand_prince_7_4_5").solve(adaptive(1e-4, {2}));
  EXPECT_NE(outcome.detail.find("rounding of t = 1"), std::string::npos) << outcome.detail;
}

/// y' = -rate (y - 1) from y = 2: y - 1 = exp(-rate (t - t0)).
struct Approach {
  static constexpr std::size_t dimension = 1;
  double rate;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = -rate * (y[0] - 1); }
  void jacobian(double, const double*, double* j) const { j[0] = -rate; }
};

/// A rate of 1e5 asks for first steps of some 1e-8; four units of rounding at the horizon are 1e-6.
TEST(SundialsRun, AFastStartIsNoObstacleToALongHorizon) {
  const auto list = entrants<Approach>({2}, {1e5});
  for (const std::string id : {"cvode/bdf", "arkode/arkstep_sdirk_5_3_4"}) {
    const Outcome outcome = find(list, id).solve(adaptive(1e-6, {1, 1e9}));
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    // The equilibrium is attractive: what is left of local errors is some ten tolerances.
    EXPECT_NEAR(outcome.states.back(), 1, 1e-5) << id;
  }
}

TEST(SundialsRun, ScaleAndOriginOfTimeDoNotMatter) {
  struct Clock {
    double t0, span;
  };
  for (const Clock clock : {Clock{0, 1e-11}, Clock{0, 1e11}, Clock{1e6, 1}, Clock{-1e6, 1}}) {
    for (const Entrant& entrant : entrants<Approach>({2}, {1 / clock.span}, clock.t0)) {
      if (!entrant.info.adaptive) continue;
      const Outcome outcome =
          entrant.solve(adaptive(1e-6, {clock.t0 + clock.span, clock.t0 + 2 * clock.span}));
      ASSERT_EQ(outcome.status, Status::ok)
          << entrant.info.id() << " from " << clock.t0 << ": " << outcome.detail;
      // A thousand tolerances: ARKStep's implicit tables miss theirs on linear problems by as much
      // (reports/findings/sundials.md).
      EXPECT_NEAR(outcome.states.back(), 1 + std::exp(-2), 1e-3) << entrant.info.id();
    }
  }
}

TEST(SundialsFault, ToleranceBelowRoundingIsRefused) {
  const auto list = entrants<Witch>({1, 0});
  for (const std::string& id : one_of_each) {
    if (!find(list, id).info.adaptive) continue;
    const Outcome outcome = find(list, id).solve(adaptive(1e-18, {2}));
    EXPECT_EQ(outcome.status, Status::refused) << id << ": " << outcome.detail;
    EXPECT_NE(outcome.detail.find("TOO_MUCH_ACC"), std::string::npos) << outcome.detail;
  }
}

TEST(SundialsFault, FixedPointIterationThatDivergesIsReported) {
  // At h |f_y| = 10 the iteration of Adams' method cannot converge.
  const auto list = entrants<ManyDecays>(std::vector<double>(200, 1.0));
  const Outcome outcome = find(list, "cvode/adams_held_1").solve(fixed(20, {1}));
  EXPECT_EQ(outcome.status, Status::newton_failed) << outcome.detail;
  EXPECT_NE(outcome.detail.find("CV_CONV_FAILURE"), std::string::npos) << outcome.detail;
}

/// y' = 2 t from 0: state and slope are of no size at the start.
struct FromRest {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double*, double* dydt) const { dydt[0] = 2 * t; }
  void jacobian(double, const double*, double* j) const { j[0] = 0; }
};

// Where backward Euler's equation can be solved it is: the adapter asked for corrections below
// 1e-14, which is less than the rounding of a predictor of 1 - h k = 1e6, and for at most 50
// iterations.
TEST(SundialsFault, HeldStepsFailWhereTheirIterationDoes) {
  const auto solve = [](const char* id, double k) {
    return find(entrants<Decay>({1}, Decay{-k}), id).solve(fixed(10, {10}));
  };
  // Rounding of the first step's predictor, h k times 2^-53, is what remains of the state.
  for (const double k : {1e2, 1e4, 1e6}) {
    const Outcome outcome = solve("cvode/bdf_held_1", k);
    ASSERT_EQ(outcome.status, Status::ok) << k << ": " << outcome.detail;
    EXPECT_NEAR(outcome.states.at(0), std::pow(1 + k, -10), 1e-15 * k) << k;
  }
  for (const char* id : {"cvode/bdf_held_1", "cvode/adams_held_1"}) {
    const Outcome from_rest = find(entrants<FromRest>({0}), id).solve(fixed(10, {1}));
    ASSERT_EQ(from_rest.status, Status::ok) << id << ": " << from_rest.detail;
    EXPECT_NEAR(from_rest.states.at(0), 1.1, 1e-10) << id;  // the sum of 2 i h^2, to its iteration
  }
  const Outcome contracts = solve("cvode/adams_held_1", 0.99);
  ASSERT_EQ(contracts.status, Status::ok) << contracts.detail;
  // A remainder of 1e-14 of the first step is a hundred times as much before the rest contracts.
  EXPECT_NEAR(contracts.states.at(0), std::pow(1.99, -10), 1e-11);
  EXPECT_EQ(solve("cvode/adams_held_1", 1.01).status, Status::newton_failed);
}

TEST(SundialsNewton, KrylovServesLargeProblemsWithoutAMatrix) {
  const auto list = entrants<ManyDecays>(std::vector<double>(200, 1.0));
  for (const std::string id : {"cvode/bdf", "arkode/arkstep_sdirk_5_3_4"}) {
    const Outcome outcome = find(list, id).solve(adaptive(1e-6, {0.5}));
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    EXPECT_EQ(outcome.counters.jacobian_evaluations, 0u);
    for (std::size_t i = 0; i < 200; ++i)  // decaying solution: some ten tolerances
      EXPECT_NEAR(outcome.states[i], std::exp(-0.5 * ManyDecays::rate(i)), 3e-5) << id << ' ' << i;
  }
  // Fourth order: from 40 to 80 steps the error of the slowest component falls to a sixteenth.
  const Entrant& sdirk = find(list, "arkode/arkstep_sdirk_5_3_4");
  const auto error = [&](std::uint64_t steps) {
    const Outcome outcome = sdirk.solve(fixed(steps, {4}));
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
    return std::abs(outcome.states.at(0) - std::exp(-4.0));
  };
  EXPECT_NEAR(std::log2(error(40) / error(80)), 4, 0.25);
}

TEST(SundialsNewton, DifferenceQuotientsServeProblemsWithoutAJacobian) {
  const auto with = entrants<Witch>({1, 0});
  const auto without = entrants<WitchWithoutJacobian>({1, 0});
  const std::string id = "arkode/arkstep_kvaerno_7_4_5";
  const Outcome a = find(with, id).solve(fixed(50, {2}));
  const Outcome b = find(without, id).solve(fixed(50, {2}));
  ASSERT_EQ(b.status, Status::ok) << b.detail;
  EXPECT_EQ(a.counters.jacobian_evaluations, 50u);
  EXPECT_EQ(b.counters.jacobian_evaluations, 50u);
  EXPECT_GT(b.counters.rhs_evaluations, a.counters.rhs_evaluations);
  // Both iterate to 1e-14 in each of 7 * 50 stages.
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(a.states[i], b.states[i], 1e-11);
}

TEST(SundialsRun, ThreadsDoNotDisturbEachOther) {
  const auto list = entrants<Witch>({1, 0});
  const auto solve_all = [&] {
    std::vector<double> states;
    for (int repetition = 0; repetition < 20; ++repetition)
      for (const std::string& id : one_of_each) {
        const Entrant& entrant = find(list, id);
        const Outcome outcome = entrant.solve(any_request(entrant.info, {1, 2}));
        states.insert(states.end(), outcome.states.begin(), outcome.states.end());
      }
    return states;
  };
  const std::vector<double> alone = solve_all();
  std::array<std::vector<double>, 2> together;
  std::array<std::thread, 2> threads;
  for (std::size_t i = 0; i < 2; ++i)
    threads[i] = std::thread([&, i] { together[i] = solve_all(); });
  for (std::thread& thread : threads) thread.join();
  ASSERT_EQ(alone.size(), 20u * one_of_each.size() * 4u);
  EXPECT_EQ(together[0], alone);  // bit for bit
  EXPECT_EQ(together[1], alone);
}

TEST(SundialsRun, AParameterMovedBetweenSolvesIsSeen) {
  const auto problem = std::make_shared<Decay>();
  Contest<Decay> contest;
  contest.problem = problem;
  contest.y0 = std::make_shared<const std::vector<double>>(1, 1.0);
  const std::vector<Entrant> list =
      tests::enrolled_on(erase(contest), adapters::sundials::add_solvers);
  for (const double lambda : {-1.0, -2.0}) {
    problem->lambda = lambda;
    for (const std::string& id : one_of_each) {
      const Entrant& entrant = find(list, id);
      const Outcome outcome = entrant.solve(any_request(entrant.info, {1}));
      ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
      // Order 1 with 200 steps is off by some 2e-3.
      EXPECT_NEAR(outcome.states[0], std::exp(lambda), 5e-3) << id;
    }
  }
}

}  // namespace
}  // namespace odeum::sundials_tests::sundials_fault_test
