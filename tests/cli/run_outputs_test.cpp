// SPDX-License-Identifier: BSD-3-Clause
// odeum run with outputs and without, and its exit code.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::run_outputs_test {
namespace {

// The amplification of errors was measured up to each of 500 outputs, for a hundred times as long
// as the run took, and the answer was another one than without outputs.
TEST(RunOutputs, AreNotJudged) {
  const TemporaryFolder folder;
  const auto answer = [&](const std::string& more) {
    const std::string text =
        shell("odeum run fput_alpha --solver dormand_prince853 --tol 1e-6 --no-truth" + more)
            .output;
    const std::size_t at = text.find("answer  ");
    return at == std::string::npos ? text : text.substr(at, text.find('\n', at) - at);
  };
  const std::string alone = answer("");
  EXPECT_EQ(alone.find("answer  explained"), 0U) << alone;
  EXPECT_EQ(answer(" --out " + folder.path().string()), alone);
}

// With 500 outputs ARKODE evaluated 500 times more, odeum/verner98 twelve times as often, and steps
// of GSL and odeint ended on them, all of which the run's counts said.
TEST(RunOutputs, ChangeNoCountAndNoEnd) {
  const TemporaryFolder folder;
  std::string run = "odeum run lotka_volterra --tol 1e-6 --format json";
  for (const char* solver :
       {"arkode/erkstep_dormand_prince_7_4_5", "arkode/arkstep_zonneveld_5_3_4",
        "arkode/arkstep_kvaerno_7_4_5", "cvode/bdf", "gsl/rk8pd", "odeint/runge_kutta_dopri5",
        "odeum/verner98", "odeum/esdirk43", "odeum/radau_iia5", "odeum/rk4"})
    run += std::string(" --solver ") + solver;
  const auto rows = [](const std::string& command) {
    auto json = nlohmann::json::parse(shell(command + " 2>/dev/null").output);
    // What is said of the truth depends on the times at which it is asked for.
    for (auto& row : json["runs"])
      for (const char* key : {"truth", "floor", "explained_error", "states"}) row.erase(key);
    return json.dump(1);
  };
  const std::string alone = rows(run);
  EXPECT_NE(alone.find("evaluations"), std::string::npos) << alone;
  EXPECT_EQ(rows(run + " --out " + folder.path().string()), alone);
}

// The table of an explicit method's run on a stiff problem had 10^7 rows, and took 10 GB to make.
TEST(RunOutputs, OfManyStepsTheTableHasTheShortestAndTheLongestOfGroups) {
  const TemporaryFolder folder;
  write_text(folder.path() / "stiff.yaml",
             "states: {x: 0}\nequations: {x: -1e5*(x - cos(t))}\ntime: {end: 2}\n");
  const Result run = shell("cd '" + folder.path().string() +
                           "' && odeum run stiff.yaml --solver dormand_prince54 --tol 1e-3 "
                           "--no-truth --out out && wc -l <out/steps.csv");
  const int lines = std::stoi(run.output.substr(run.output.rfind('\n', run.output.size() - 2)));
  // Stable steps are at most 3.3/1e5: there are at least 60,000.
  EXPECT_GT(lines, 20'000) << run.output;
  EXPECT_LE(lines, 40'001) << run.output;
}

// trajectory.csv had the distance, and the other places that over the scale.
TEST(RunOutputs, SayOneError) {
  const TemporaryFolder folder;
  write_text(folder.path() / "scaled.yaml",
             "states: {x: 1000, v: 0}\nequations: {x: v, v: -x}\n"
             "time: {end: 10, stops: [5, 10]}\n");
  const std::string run = "cd '" + folder.path().string() +
                          "' && odeum run scaled.yaml --solver dormand_prince54 --tol 1e-5 ";
  const std::string text = shell(run + "--out out").output;
  const double said = std::stod(text.substr(text.find("\nerror") + 8));
  EXPECT_GT(said, 0) << text;
  EXPECT_NE(text.find("\nerrors  at t = 10, of each state in its own unit: x "), std::string::npos)
      << text;
  // The last field of a solver's last row.
  const auto last = [&](const char* file) {
    const std::string row = shell("grep ',dormand_prince54,' '" +
                                  (folder.path() / "out" / file).string() + "' | tail -n 1")
                                .output;
    return row.substr(0, row.size() - 1);
  };
  const std::string step = last("trajectory.csv");
  EXPECT_NEAR(std::stod(step.substr(step.rfind(',') + 1)), said, 1e-5 * said) << step;
  EXPECT_NE(last("solution.csv").find(",1000,v"), std::string::npos) << last("solution.csv");
  const auto row =
      nlohmann::json::parse(shell(run + "--format json 2>/dev/null").output)["runs"][0];
  EXPECT_NEAR(row["error_max"], said, 1e-5 * said);
  EXPECT_EQ(row["error_unit"], 1000);
  EXPECT_TRUE(row["error_component"] == "x" || row["error_component"] == "v") << row;
}

// A run that ends ok with an error of hundreds of times the solution's size had exit code 0.
TEST(RunCode, IsThatOfAFailureWhereEachRunHasDiverged) {
  // Explicit Euler grows by a third in each of 20 steps; RK4 is stable there.
  const Result diverged = shell("odeum run osc_under --solver explicit_euler --step 1");
  EXPECT_NE(diverged.output.find("has diverged"), std::string::npos) << diverged.output;
  EXPECT_EQ(diverged.code, 3) << diverged.output;
  const Result one = shell("odeum run osc_under --solver explicit_euler --solver rk4 --step 1");
  EXPECT_NE(one.output.find("has diverged"), std::string::npos) << one.output;
  EXPECT_EQ(one.code, 0) << one.output;
}

// Without them an implicit step looks as cheap as its evaluations.
TEST(SceneCommands, WhatLinearSolversTakeIsPrinted) {
  const Result result =
      shell("odeum run chain --solver implicit_euler_linearised --step 1/60 --until 0.1");
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find(" products in linear solvers"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace odeum::tests::run_outputs_test
