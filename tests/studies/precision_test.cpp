// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/precision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <string>
#include <thread>

#include "odeum/studies/stopwatch.hpp"

namespace odeum::study::precision_test {
namespace {

PrecisionRow row(const char* library, const char* solver, double error, double ns) {
  PrecisionRow row;
  row.case_id = "made_up";
  row.library = library;
  row.solver = solver;
  row.mode = Mode::adaptive;
  row.status = "ok";
  row.error = row.near_error = error;
  row.wall_ns_min = ns;
  row.wall_ns_median = 1.1 * ns;
  row.repetitions = 3;
  return row;
}

const PrecisionSummary& at(const std::vector<PrecisionSummary>& lines, double error) {
  for (const PrecisionSummary& line : lines)
    if (std::abs(line.error / error - 1) < 1e-9) return line;
  throw std::runtime_error("no such error");
}

// A time between those of two runs, beside the setting of one of them, is nobody's.
TEST(Summary, ComparesRunsThatWereMade) {
  const auto lines = summarise({row("odeum", "a", 1e-3, 100), row("odeum", "a", 1e-5, 1000),
                                row("gsl", "b", 1e-3, 400), row("gsl", "b", 1e-5, 4000)},
                               1e-16);
  const PrecisionSummary& line = at(lines, 1e-4);
  EXPECT_EQ(line.own, "odeum/a");
  EXPECT_EQ(line.peer, "gsl/b");
  EXPECT_EQ(line.own_ns, 1000);
  EXPECT_NEAR(line.ratio, 4, 1e-12);
  // The medians were made 1.1 times the least times.
  EXPECT_NEAR(line.ratio_low, 4 / 1.1, 1e-12);
  EXPECT_NEAR(line.ratio_high, 4 * 1.1, 1e-12);
  EXPECT_EQ(line.reason, "");
}

// The error of a run may cross zero at its setting: such a run tells nothing of the next one.
TEST(Summary, ARunThatReachesAnErrorByLuckIsNotTheFastest) {
  PrecisionRow lucky = row("odeum", "lucky", 1e-4, 50), alone = row("odeum", "alone", 1e-4, 60);
  lucky.near_error = 3e-4;
  alone.near_error = std::nan("");  // its neighbours were not run
  const auto rows = fastest({lucky, alone, row("odeum", "a", 5e-5, 100)}, 1e-16);
  for (const FastestRow& each : rows)
    if (each.compared < 1.1e-4) {
      EXPECT_EQ(each.solver, "a") << each.compared;
      EXPECT_EQ(each.error, 5e-5);
    }
  EXPECT_EQ(fastest({lucky}, 1e-16).size(), 2U);  // at 1e-2 and 1e-3 luck does not matter
}

// A pendulum's 190 steps had 4.4e-4, 186 had 0.027 and 210 had 0.0021, and the first screen had the
// 190 as the fastest at 1e-3.
TEST(Summary, ARunWhoseNeighboursAreSeveralTimesWorseIsNotTaken) {
  EXPECT_TRUE(keeps_error(4.4e-4, 9e-4, 1e-3));
  EXPECT_TRUE(keeps_error(6e-4, 1.8e-3, 1e-3));
  EXPECT_FALSE(keeps_error(4e-4, 1.8e-3, 1e-3));
  EXPECT_FALSE(keeps_error(4.4e-4, 0.027, 1e-3));
  EXPECT_TRUE(keeps_error(1e-9, 1e-4, 1e-3));  // luck does not matter here
}

TEST(Summary, NeverExtrapolates) {
  const auto lines = summarise({row("odeum", "a", 1e-3, 100), row("gsl", "b", 1e-5, 50)}, 1e-16);
  // A solver more accurate than the level has reached it.
  EXPECT_EQ(at(lines, 1e-2).own_ns, 100);
  EXPECT_EQ(at(lines, 1e-2).peer_ns, 50);
  EXPECT_EQ(at(lines, 1e-4).own, "");
  EXPECT_EQ(at(lines, 1e-4).reason, "no own solver reaches it");
  EXPECT_TRUE(std::isnan(at(lines, 1e-4).ratio));
  EXPECT_EQ(at(lines, 1e-9).reason, "no solver reaches it");
}

TEST(Summary, WhatWasNotRunDoesNotFallShort) {
  EXPECT_EQ(at(summarise({row("odeum", "a", 1e-3, 100)}, 1e-16), 1e-3).reason, "no peer was run");
  EXPECT_EQ(at(summarise({row("gsl", "b", 1e-3, 100)}, 1e-16), 1e-3).reason,
            "no own solver was run");
}

TEST(Summary, BelowTheFloorNobodyIsFaster) {
  const auto lines = summarise({row("odeum", "a", 1e-12, 100), row("gsl", "b", 1e-12, 50)}, 2e-11);
  EXPECT_EQ(at(lines, 1e-10).ratio, 0.5);
  EXPECT_EQ(at(lines, 1e-11).reason, "at the truth's floor");
  EXPECT_TRUE(std::isnan(at(lines, 1e-11).ratio));
}

TEST(Pareto, KeepsWhoIsFasterOrMoreExactThanAllOthers) {
  std::vector<PrecisionRow> rows{row("odeum", "fast", 1e-2, 10), row("gsl", "beaten", 1e-2, 20),
                                 row("gsl", "exact", 1e-6, 100), row("odeum", "both", 1e-4, 50),
                                 row("gsl", "failed", std::nan(""), 1)};
  mark_pareto(rows);
  EXPECT_TRUE(rows[0].pareto);
  EXPECT_FALSE(rows[1].pareto);
  EXPECT_TRUE(rows[2].pareto);
  EXPECT_TRUE(rows[3].pareto);
  EXPECT_FALSE(rows[4].pareto);
}

TEST(Times, MedianIsTheMiddle) {
  EXPECT_EQ((Times{{3, 1, 2}}.median()), 2);
  EXPECT_EQ((Times{{4, 1, 2, 3}}.median()), 2.5);
  EXPECT_EQ((Times{{3, 1, 2}}.min()), 1);
  EXPECT_TRUE(std::isnan(Times{}.min()));
}

/// Two solvers on a small case: counted, timed, and what does not fit has a row with its reason.
// The calibration takes the least of several short runs and so excludes interruptions by other
// processes; the processor time does not.
TEST(Times, ProcessorTimeStandsStillWhileTheThreadWaits) {
  const double before = thread_seconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_LT(thread_seconds() - before, 0.01);
  const double working = thread_seconds();
  calibration_ns();
  EXPECT_GT(thread_seconds() - working, 1e-4);
  EXPECT_TRUE(disturbed({0, 0.6, ""}));
  EXPECT_TRUE(disturbed({-0.1, 1, ""}));
  EXPECT_FALSE(disturbed({0.04, 0.96, ""}));
  EXPECT_FALSE(disturbed({}));
}

// One fixed step of RK4 is exact on a free fall: the same two runs are the fastest at every error.
TEST(Precision, EqualLinesOfItsTableAreOne) {
  for (const auto& study : make_studies()) {
    if (study->declaration().name != "precision") continue;
    study->measure({.cases = {"free_fall"},
                    .solvers = {"odeum/rk4", "odeum/explicit_euler"},
                    .own = {{"seconds", "0.01"}, {"attempts", "1"}}},
                   Runner());
    const std::string table = study->table();
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2) << table;
    EXPECT_NE(table.find("1e-12  odeum/rk4"), std::string::npos) << table;
    EXPECT_EQ(table.find("nan"), std::string::npos) << table;
  }
}

// A first-order method at fine tolerances takes 1e5 steps where one of order 9 takes ten.
TEST(Precision, WhatIsFarBehindIsTimedOnce) {
  const PrecisionResult result =
      measure_precision({.cases = {"lotka_volterra"},
                         .solvers = {"odeum/adams_bashforth1", "odeum/verner98"},
                         .own = {{"seconds", "0.2"}, {"attempts", "1"}}});
  std::size_t once = 0, often = 0;
  for (const PrecisionRow& row : result.rows) {
    if (row.status != "ok" || row.mode != Mode::adaptive) continue;
    const bool far = row.solver == "adams_bashforth1" && row.setting < 2e-7;
    ASSERT_GE(row.repetitions, 1U);
    EXPECT_LE(row.repetitions, far ? 1U : 15U) << row.setting;
    once += far;
    often += row.solver == "verner98" && row.repetitions > 1;
  }
  EXPECT_GE(once, 1U);
  // The bound is half of ten settings: a stall of the machine during its first repetition makes a
  // run seem far behind.
  EXPECT_GE(often, 5U);
}

TEST(Precision, HasARowForEverySettingAndForWhatDoesNotFit) {
  const PrecisionResult result =
      measure_precision({.cases = {"lotka_volterra"},
                         .solvers = {"odeum/cash_karp54", "gsl/rkck", "odeum/leapfrog"},
                         .own = {{"seconds", "0.05"}}});
  int ok = 0, unfit = 0;
  double last[2] = {1, 1};  // settings get finer, in each mode
  for (const PrecisionRow& each : result.rows) {
    if (each.status == "not_applicable") {
      ++unfit;
      EXPECT_EQ(each.solver, "leapfrog");
      EXPECT_NE(each.detail, "");
      continue;
    }
    ASSERT_EQ(each.status, "ok") << each.detail;
    ++ok;
    EXPECT_GT(each.counters.rhs_evaluations, 0U);
    EXPECT_GE(each.repetitions, 1U);
    EXPECT_GT(each.wall_ns_min, 0);
    EXPECT_GE(each.wall_ns_median, each.wall_ns_min);
    if (each.library == "odeum") {
      EXPECT_LT(each.setting, last[each.mode == Mode::fixed]);
      last[each.mode == Mode::fixed] = each.setting;
    }
    // Timed and counted runs are one and the same here, whatever the machine.
    EXPECT_EQ(each.detail.find("ended"), std::string::npos) << each.detail;
  }
  // Ten tolerances and eight steps each, and looser tolerances up to an error of 1e-2.
  EXPECT_GE(ok, 18);
  std::map<std::string, const PrecisionRow*> loosest;
  for (const PrecisionRow& each : result.rows)
    if (each.status == "ok" && each.mode == Mode::adaptive)
      if (const PrecisionRow*& found = loosest[each.library + each.solver];
          !found || each.setting > found->setting)
        found = &each;
  EXPECT_GE(loosest.size(), 1U);
  for (const auto& [solver, row] : loosest) {
    EXPECT_GE(row->setting, 1e-3) << solver;
    EXPECT_TRUE(row->error >= 1e-2 || row->setting > 0.09) << solver << ' ' << row->setting;
  }
  EXPECT_EQ(unfit, 1);
  EXPECT_EQ(result.summary.size(), 11U);
}

// A closed form is exact at any step: as the fastest own solver it made ratios that compare no
// methods. Its rows stay.
TEST(Precision, AClosedFormIsTimedAndComparedWithNone) {
  const PrecisionResult result =
      measure_precision({.cases = {"osc_undamped"},
                         .solvers = {"odeum/exponential_propagator", "odeum/heun"},
                         .own = {{"seconds", "0.01"}, {"attempts", "1"}}});
  const auto is_closed_form = [](const auto& row) {
    return row.solver == "exponential_propagator";
  };
  EXPECT_TRUE(std::any_of(result.rows.begin(), result.rows.end(), is_closed_form));
  EXPECT_FALSE(result.fastest.empty());
  EXPECT_TRUE(std::none_of(result.fastest.begin(), result.fastest.end(), is_closed_form));
  for (const PrecisionSummary& each : result.summary)
    EXPECT_TRUE(each.own.empty() || each.own.starts_with("odeum/heun")) << each.own;
}

// Wrong where a library's options are left out: Bullet's conjugate gradients limited to four take
// half the time of its default at coarse steps (reports/peers.md).
TEST(Precision, TunesTheOptionsOfALibrary) {
  const PrecisionResult result =
      measure_precision({.cases = {"damped_oscillator_underdamped"},
                         .solvers = {"bullet/deformable_implicit", "odeum/rk4"},
                         .own = {{"seconds", "0.01"}, {"attempts", "1"}}});
  std::map<std::string, int> rows;
  for (const PrecisionRow& each : result.rows)
    if (each.library == "bullet") ++rows[each.options];
  if (rows.empty()) GTEST_SKIP() << "built without Bullet";
  EXPECT_EQ(rows.size(), 4U);
  for (const char* options : {"", "newton=2", "sweeps=16", "sweeps=4"})
    EXPECT_EQ(rows[options], rows[""]) << options;
  for (const PrecisionRow& each : result.rows)
    EXPECT_TRUE(each.library == "bullet" || each.options.empty());
}

TEST(Summary, NamesTheOptionsOfTheFastest) {
  PrecisionRow tuned = row("bullet", "b", 1e-3, 50);
  tuned.mode = Mode::fixed;
  tuned.options = "sweeps=4";
  PrecisionRow plain = tuned;
  plain.options = "";
  plain.wall_ns_min = 80;
  PrecisionRow finer = plain;
  finer.error = finer.near_error = 1e-5;
  finer.wall_ns_min = 1000;
  const auto lines = summarise({plain, finer, tuned}, 1e-16);
  EXPECT_EQ(at(lines, 1e-3).peer, "bullet/b (fixed step, sweeps=4)");
  EXPECT_EQ(at(lines, 1e-5).peer, "bullet/b (fixed step)");
  EXPECT_EQ(at(lines, 1e-4).peer_ns, 1000);
}

TEST(Precision, SaysTolerancesAndJacobian) {
  const auto rows_of = [](const char* id) {
    return measure_precision({.cases = {id},
                              .solvers = {"odeum/rodas4", "cvode/bdf", "bullet/*"},
                              .own = {{"seconds", "0.01"}, {"attempts", "1"}}})
        .rows;
  };
  for (const PrecisionRow& each : rows_of("robertson")) {
    if (each.status == "not_applicable") continue;
    EXPECT_EQ(std::count(each.absolute.begin(), each.absolute.end(), ' '), 2) << each.absolute;
    EXPECT_EQ(each.jacobian, "exact");
    EXPECT_EQ(each.setting == 1e-3, each.absolute == "1e-07 1e-13 1e-05") << each.absolute;
  }
  Case without;
  EXPECT_EQ(jacobian_of(without), "differenced");
}

}  // namespace
}  // namespace odeum::study::precision_test
