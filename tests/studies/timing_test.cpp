// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/timing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "odeum/cases/catalogue.hpp"
#include "odeum/studies/foreseen.hpp"
#include "odeum/studies/runner.hpp"

namespace odeum::study::timing_test {
namespace {

Entrant entrant_that(Status status) {
  Entrant entrant;
  entrant.solve = [status](const Request& request) {
    Outcome outcome;
    outcome.status = status;
    outcome.detail = "made up";
    const double y[2] = {1, 2};
    if (status == Status::ok) outcome.record(request.stops.back(), y, 2);
    return outcome;
  };
  return entrant;
}

TimedSolver timed_solver(const Entrant& entrant, const Entrant* inlined) {
  TimedSolver solver{&entrant, Mode::adaptive, inlined};
  TimedRun& trial = solver.trials.emplace_back();
  trial.row.status = "ok";
  trial.row.error = 0;
  trial.request.stops = {1};
  trial.request.tolerance = 1e-3;
  trial.states = {1, 2};
  trial.guarded_ns = 1000;
  return solver;
}

// A refusal or a failure takes no time: ranked, it would be the fastest of all.
TEST(Timing, ARunThatFailsWhenTimedHasNoTime) {
  const TimedCase stage(known_case("lotka_volterra"));
  const Entrant good = entrant_that(Status::ok), refusing = entrant_that(Status::refused),
                failing = entrant_that(Status::newton_failed);
  std::vector<TimedSolver> solvers{timed_solver(good, &refusing), timed_solver(failing, nullptr)};
  time_all(stage, solvers, 0.001);
  // What the inlined solver refuses is left to the ordinary one.
  EXPECT_EQ(solvers[0].inlined, nullptr);
  EXPECT_EQ(solvers[0].trials[0].row.right_hand_side, "function pointer");
  EXPECT_GE(solvers[0].trials[0].times.ns.size(), 1U);
  EXPECT_EQ(solvers[0].trials[0].row.detail, "");
  EXPECT_TRUE(solvers[1].trials[0].times.ns.empty());
  EXPECT_EQ(solvers[1].trials[0].row.detail, "the timed run ended newton_failed: made up");
}

// A run that is far behind and takes a millisecond an evaluation is timed by its guarded run.
TEST(Timing, ASlowRunIsNotMadeTwice) {
  const TimedCase stage(known_case("lotka_volterra"));
  int solves = 0;
  Entrant good = entrant_that(Status::ok), slow = good;
  slow.solve = [&solves, solve = good.solve](const Request& request) {
    ++solves;
    return solve(request);
  };
  std::vector<TimedSolver> solvers{timed_solver(good, nullptr), timed_solver(slow, nullptr)};
  solvers[0].trials[0].guarded_ns = 1e6;
  solvers[0].trials[0].row.counters.rhs_evaluations = 1;
  TimedRun& behind = solvers[1].trials[0];
  behind.row.counters.rhs_evaluations = 4;
  behind.guarded_ns = 4e6;
  time_all(stage, solvers, 0.001);
  EXPECT_EQ(solves, 0);
  EXPECT_EQ(behind.row.right_hand_side, "guarded");
  EXPECT_EQ(behind.times.ns, std::vector<double>{4e6});
  EXPECT_EQ(solvers[0].trials[0].row.right_hand_side, "function pointer");
  EXPECT_GE(solvers[0].trials[0].times.ns.size(), 2U);
}

// The guard of cheap evaluations would be timed with them: 4 ns of each 40.
TEST(Timing, ARunOfCheapEvaluationsIsTimedWithoutItsGuard) {
  const TimedCase stage(known_case("lotka_volterra"));
  const Entrant good = entrant_that(Status::ok);
  std::vector<TimedSolver> solvers{timed_solver(good, nullptr), timed_solver(good, nullptr)};
  TimedRun& behind = solvers[1].trials[0];
  behind.row.counters.rhs_evaluations = 100'000;
  behind.guarded_ns = 4e6;
  time_all(stage, solvers, 0.001);
  EXPECT_EQ(behind.row.right_hand_side, "function pointer");
  EXPECT_EQ(behind.times.ns.size(), 1U);
  // Less its guard it would take 3.2 ms, 1.3 of the fastest: it may be that one.
  solvers[0].trials[0].guarded_ns = 2.5e6;
  solvers[0].trials[0].row.error = behind.row.error = 0;
  behind.done = false;
  time_all(stage, solvers, 0.001);
  EXPECT_GT(behind.times.ns.size(), 1U);
}

// At half the step a fixed-step method takes twice the evaluations: what is certain to exceed the
// budget is not run, and says so.
TEST(Timing, WhatIsForeseenToExceedTheBudgetIsNotRun) {
  const std::vector<Cost> known{{100, 400}, {200, 800}};
  Request next;
  next.steps = 400;
  EXPECT_EQ(foreseen_work(known, next), 0.75 * 1600);
  const PrecisionResult result =
      measure_precision({.cases = {"lotka_volterra"},
                         .solvers = {"odeum/heun"},
                         .own = {{"seconds", "0.01"}, {"attempts", "1"}}});
  std::size_t foreseen = 0;
  for (const PrecisionRow& each : result.rows) {
    if (each.detail.rfind("not run: by coarser settings", 0) != 0) continue;
    ++foreseen;
    EXPECT_EQ(each.status, "over_budget");
    EXPECT_TRUE(std::isnan(each.error));
    EXPECT_EQ(each.counters.rhs_evaluations, 0U);
  }
  EXPECT_EQ(foreseen, 1U);
}

// Every time of the first page is a run's own, whose error is the one asked for, not by luck.
TEST(Timing, TheFastestAreRunsWhoseErrorIsTheOneAskedFor) {
  const PrecisionResult result =
      measure_precision({.cases = {"lotka_volterra"},
                         .solvers = {"odeum/rk4", "odeum/dormand_prince54"},
                         .own = {{"seconds", "0.01"}, {"attempts", "1"}}});
  int near = 0;
  for (const FastestRow& each : result.fastest) {
    const auto run = std::find_if(result.rows.begin(), result.rows.end(), [&](const auto& row) {
      return row.solver == each.solver && row.mode == each.mode && row.setting == each.setting;
    });
    ASSERT_NE(run, result.rows.end()) << each.solver << ' ' << each.setting;
    EXPECT_EQ(run->wall_ns_min, each.wall_ns_min);
    EXPECT_EQ(run->counters.rhs_evaluations, each.counters.rhs_evaluations);
    EXPECT_EQ(run->error, each.error);
    EXPECT_LE(each.error, each.compared);
    EXPECT_LE(each.near_error, 2 * each.compared);
    near += each.error > each.compared / 2;
  }
  // Half a decade apart the settings of the study have no such error at most of them.
  EXPECT_GE(near, static_cast<int>(result.fastest.size() * 3 / 4));
  EXPECT_GE(result.fastest.size(), 8U);
}

/// A fixed-step solver whose runs are timed: steps, error and time of each.
TimedSolver with_runs(const TimedCase& stage, const char* id,
                      const std::vector<std::array<double, 3>>& runs) {
  TimedSolver solver{&find_solver(stage.c.entrants, id), Mode::fixed, nullptr};
  for (const auto& [steps, error, ns] : runs) {
    TimedRun& trial = solver.trials.emplace_back();
    trial.request.stops = stage.stops;
    trial.request.steps = static_cast<std::uint64_t>(steps);
    trial.row.setting = 1 / steps;
    trial.row.status = "ok";
    trial.row.error = error;
    trial.row.wall_ns_min = ns;
    trial.row.repetitions = 1;
  }
  return solver;
}

// The coarsest run of the second has far less than the error. Only its time counted, so that one
// more or less decided whether it was given fewer steps.
TEST(Timing, ASolverThatCanDoWithFewerStepsIsSearched) {
  const TimedCase stage(known_case("damped_oscillator_undamped"));
  const auto few = static_cast<double>(8 * stage.c.settings.steps_multiple);
  std::vector<TimedSolver> solvers{
      with_runs(stage, "odeum/rk4", {{few, 4e-3, 300}, {2 * few, 2.5e-4, 460}}),
      with_runs(stage, "odeum/dormand_nystroem64", {{few, 5e-7, 413}, {2 * few, 3e-8, 800}})};
  EXPECT_TRUE(settle_errors(stage, solvers, 1));
  const auto is_asked = [](double error) { return std::abs(error / 1e-3 - 1) < 1e-9; };
  EXPECT_TRUE(std::ranges::any_of(solvers[1].searched, is_asked));
}

}  // namespace
}  // namespace odeum::study::timing_test
