// SPDX-License-Identifier: BSD-3-Clause
// odeum run makes the runs of studies again, and says all that is known of a run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/precision/precision.hpp"
#include "support/program.hpp"

namespace odeum::tests::reproduce_test {
namespace {

nlohmann::json run_of(const std::string& arguments) {
  const Result result = shell("odeum run " + arguments + " --format json 2>/dev/null");
  EXPECT_EQ(result.code, 0) << arguments << '\n' << result.output;
  return nlohmann::json::parse(result.output)["runs"][0];
}

// Steps to a tolerance that ended at the horizon alone gave other counts and another error than the
// page that printed the command: 2.24e-3 for 1e-3 on an orbit.
TEST(Reproduce, ATimedRunHasTheErrorAndTheCountsOfItsRow) {
  const study::PrecisionResult result =
      study::measure_precision({.cases = {"kepler_e09"},
                                .solvers = {"odeum/dormand_prince54", "odeum/rk4"},
                                .own = {{"seconds", "0.01"}, {"attempts", "1"}}});
  int made = 0;
  for (std::size_t i = 0; i < result.rows.size(); i += 5) {
    const study::PrecisionRow& row = result.rows[i];
    if (row.status != "ok") continue;
    ++made;
    const bool fixed = row.mode == Mode::fixed;
    const std::string setting = fixed ? fmt::format("--steps {}", row.counters.steps)
                                      : fmt::format("--tol {}", row.setting);
    const nlohmann::json run =
        run_of(fmt::format("kepler_e09 --solver odeum/{} {} --stops speed", row.solver, setting));
    EXPECT_EQ(run["error_max"], row.error) << row.solver << ' ' << setting;
    EXPECT_EQ(run["rhs_evaluations"], row.counters.rhs_evaluations) << row.solver << ' ' << setting;
    EXPECT_EQ(run["rejected_steps"], row.counters.rejected_steps) << row.solver << ' ' << setting;
  }
  EXPECT_GE(made, 4);
}

TEST(Reproduce, ARunOfTheStudyOfOrdersToo) {
  study::Options options{.cases = {"lotka_volterra"}, .solvers = {"odeum/dormand_prince54"}};
  options.own["mode"] = "adaptive";
  const study::ConvergenceResult result = study::converge(options);
  ASSERT_GE(result.rows.size(), 4U);
  for (const study::ConvergenceRow& row : {result.rows[0], result.rows[3]}) {
    const nlohmann::json run = run_of(fmt::format(
        "lotka_volterra --solver odeum/dormand_prince54 --tol {} --stops orders", row.setting));
    EXPECT_EQ(run["error_max"], row.error);
    EXPECT_EQ(run["error_rms"], row.error_rms);
    EXPECT_EQ(run["rhs_evaluations"], row.counters.rhs_evaluations);
  }
}

// A scene's page gives the largest error of a coordinate at the quarters of its time; the command
// beside it ignored --stops and printed distances at the frames.
TEST(Reproduce, ARunOfASceneToo) {
  const Result result = shell(
      "odeum converge bouncing_triangle --solver rk4 --solver dormand_prince54 --quick "
      "--format json 2>/dev/null");
  ASSERT_EQ(result.code, 0) << result.output;
  std::map<std::string, int> made;
  const nlohmann::json all = nlohmann::json::parse(result.output);
  for (const nlohmann::json& row : all["convergence.csv"]) {
    const std::string mode = row["mode"];
    if (row["status"] != "ok" || made[mode] == 2) continue;
    ++made[mode];
    const std::string setting = mode == "fixed"
                                    ? fmt::format("--steps {}", row["steps"].get<int>())
                                    : fmt::format("--tol {}", row["setting"].get<double>());
    const nlohmann::json run =
        run_of(fmt::format("bouncing_triangle --solver odeum/{} {} --stops orders",
                           row["solver"].get<std::string>(), setting));
    EXPECT_EQ(run["error_max"], row["error_max"]) << setting;
    EXPECT_EQ(run["rhs_evaluations"], row["rhs_evaluations"]) << setting;
  }
  EXPECT_EQ(made, (std::map<std::string, int>{{"adaptive", 2}, {"fixed", 2}}));
}

// It had --tol, which is another run.
TEST(Reproduce, TheCommandThatSaysMoreOfASceneHasItsTolerances) {
  const std::string setting = "chain --solver odeum/dormand_prince54 --rtol 2e-13 --atol 1e-300";
  const Result result = shell("odeum run " + setting);
  EXPECT_EQ(result.code, 3) << result.output;
  EXPECT_NE(result.output.find("more       odeum why " + setting + "\n"), std::string::npos)
      << result.output;
}

TEST(Reproduce, WhatAStudyDoesNotTakeIsRefusedForAScene) {
  for (const char* option : {"--frames 3", "--max-particles 9", "--max-megabytes 1"}) {
    const Result result =
        shell(fmt::format("odeum run chain --solver rk4 --step 0.01 {} --stops orders", option));
    EXPECT_EQ(result.code, 2) << result.output;
    EXPECT_NE(result.output.find("as studies run it"), std::string::npos) << result.output;
  }
}

TEST(Reproduce, OptionsThatTheLibraryDoesNotHaveAreRefused) {
  for (const auto& [arguments, sentence] :
       {std::pair{"--solver rk4 --step 0.1 --option sweeps=4", "has no option sweeps"},
        std::pair{"--solver rk4 --steps 0", "--steps: got 0"},
        std::pair{"--solver rk4 --steps 4 --stops sped", "--stops"},
        std::pair{"--solver rk4 --steps 4 --stops speed --until 1", "--until"}}) {
    const Result result = shell(std::string("odeum run free_fall ") + arguments);
    EXPECT_EQ(result.code, 2) << result.output;
    EXPECT_NE(result.output.find(sentence), std::string::npos) << result.output;
  }
}

// Two ways to print a run stood side by side, and the one without remarks was taken.
TEST(Reproduce, RemarksArePrinted) {
  const Result result = shell("odeum run robertson_40 --solver rodas4 --rtol 1e-3 --atol 1e-3");
  EXPECT_NE(result.output.find("remark  y1 never exceeds the absolute tolerance"),
            std::string::npos)
      << result.output;
}

}  // namespace
}  // namespace odeum::tests::reproduce_test
