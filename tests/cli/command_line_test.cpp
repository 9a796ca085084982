// SPDX-License-Identifier: BSD-3-Clause
// The built program: exit codes, messages, files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "odeum/record/output_folder.hpp"
#include "support/program.hpp"

namespace odeum::command_line_test {
namespace {

namespace fs = std::filesystem;

using tests::Result;
using tests::shell;

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class CommandLine : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::path(testing::TempDir()) /
        ("odeum_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  /// The command, with SIGINT once the test `when` holds.
  Result interrupted(const std::string& words, const std::string& when) const;
  fs::path folder_;
};

TEST_F(CommandLine, ExplainsItselfWithoutArguments) {
  const Result result = shell("odeum");
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.output.find("odeum run damped_oscillator_undamped"), std::string::npos);
}

TEST_F(CommandLine, RunsASceneAndWritesItsFiles) {
  const Result result = shell("odeum run spinning_pair --until 0.5 --out " + in("pair"));
  EXPECT_EQ(result.code, 0) << result.output;
  for (const char* line : {"scene      spinning pair", "term       springs", "separable, nonlinear",
                           "kernel     edge list", "fits  ", "status     ok"})
    EXPECT_NE(result.output.find(line), std::string::npos) << line << "\n" << result.output;
  for (const char* name : {"final.csv", "trajectory.csv", "energy.csv", "replay.html",
                           "trajectory.vtk.series", "vtk/frame_000000.vtk"})
    EXPECT_TRUE(fs::exists(fs::path(in("pair")) / name)) << name;
  EXPECT_NE(shell("odeum list scenes").output.find("hanging_cloth"), std::string::npos);
  EXPECT_EQ(shell("odeum run fountain --until 0.2").code, 0) << "no particles before the start";
  // A failed run writes the states reached, and no final state.
  EXPECT_EQ(shell("odeum run stiff_rope --solver rk4 --step 0.01 --out " + in("rope")).code, 3);
  EXPECT_FALSE(fs::exists(in("rope/final.csv")));
  EXPECT_TRUE(fs::exists(in("rope/energy.csv")));
}

struct Misuse {
  const char* command;
  const char* sentence;  ///< part of the message
  friend std::ostream& operator<<(std::ostream& out, const Misuse& x) { return out << x.command; }
};

class BadInput : public testing::TestWithParam<Misuse> {};

TEST_P(BadInput, IsRefusedWithASentence) {
  const Result result = shell(GetParam().command);
  EXPECT_EQ(result.code, 2) << result.output;
  EXPECT_NE(result.output.find(GetParam().sentence), std::string::npos) << result.output;
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, BadInput,
    testing::Values(
        Misuse{"odeum frobnicate", "frobnicate"}, Misuse{"odeum run", "case is required"},
        Misuse{"odeum run lotka_voltera --solver rk4 --step 0.1", "did you mean lotka_volterra?"},
        Misuse{"odeum run ../lotka_volterra --solver rk4 --step 0.1", "unknown case"},
        Misuse{"odeum converge --case kepler", "did you mean one of kepler_e06, kepler_e09?"},
        Misuse{"odeum converge --case nothing_like_it", "; see odeum list cases"},
        Misuse{"odeum converge --case freefall", "did you mean free_fall?"},
        Misuse{"odeum run lotka_volterra --solver rk5 --step 0.1", "did you mean odeum/rk4?"},
        Misuse{"odeum run lotka_volterra --solver rk4", "--step or --tol"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step 0.1 --tol 1e-3", "excludes"},
        Misuse{"odeum run lotka_volterra --step 0.1", "--solver is required"},
        Misuse{"odeum run hanging_clot", "did you mean hanging_cloth?"},
        Misuse{"odeum run /nonexistent.yaml",
               "odeum: /nonexistent.yaml:1:1: problem: cannot be read; got No such file"},
        Misuse{"odeum run jelly_cube --solver leapfrog --step 0.01", "does not fit this scene"},
        Misuse{"odeum run chain --until 1 --step 2", "at most the horizon 1"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step 0",
               "got 0, expected a positive number"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step -1", "got -1"},
        Misuse{"odeum precision --seconds -1", "got -1, expected a number from"},
        Misuse{"odeum precision --seconds nan", "got nan, expected a number from"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step nan", "got nan"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step inf", "got inf"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step 0,1", "step"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step 11", "at most the horizon 10"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step 1e-12", "1e+09 steps"},
        Misuse{"odeum run lotka_volterra --solver rk4 --tol 0", "machine precision"},
        Misuse{"odeum run lotka_volterra --solver rk4 --tol 1e-17", "machine precision"},
        Misuse{"odeum run lotka_volterra --solver rk4 --tol nan", "got nan"},
        Misuse{"odeum run lotka_volterra --solver rk4 --rtol 1e-3", "requires --atol"},
        Misuse{"odeum run lotka_volterra --solver rk4 --atol 1e-3", "requires --rtol"},
        Misuse{"odeum run lotka_volterra --solver rk4 --rtol 1e-3 --atol -1", "--atol: got -1"},
        Misuse{"odeum run lotka_volterra --solver rk4 --rtol 1e-3 --atol nan", "--atol: got nan"},
        Misuse{"odeum run lotka_volterra --solver rk4 --rtol 1e-3 --atol 1,2,3",
               "--atol: got 3 numbers, expected one, or 2"},
        Misuse{"odeum run lotka_volterra --solver rk4 --rtol 0 --atol 1", "--rtol: got 0"},
        Misuse{"odeum run kepler_e06 --solver rk4 --rtol 1e-3 --atol z=1",
               "no component z; did you mean x?"},
        Misuse{"odeum run kepler_e06 --solver rk4 --rtol 1e-3 --atol all", "got all, expected"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step 1/0", "--step: got 1/0"},
        Misuse{"odeum run spinning_pair --rtol 1e-3 --atol 1,2", "expected one for a scene"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step 0.1 --until -1", "--until"},
        Misuse{"odeum run lotka_volterra --solver rk4 --step 0.1 --until nan", "--until"},
        Misuse{"odeum run lotka_volterra --solver leapfrog --step 0.1",
               "does not fit lotka_volterra"},
        Misuse{"odeum run damped_oscillator_undamped --solver leapfrog --tol 1e-3",
               "fixed step only"},
        Misuse{"odeum converge --case nothing --out /dev/null/x", "no case matches"},
        Misuse{"odeum converge --case '!*' --out /dev/null/x", "no case is left by '!*'"},
        Misuse{"odeum mesh --most 7.5 --out /dev/null/x", "expected a whole number from 6 to 192"},
        Misuse{"odeum converge --solver odeum/rk9 --out /dev/null/x", "no solver matches"},
        Misuse{"odeum drift --case keplr_e06 --out /dev/null/x", "did you mean kepler_e06"},
        Misuse{"odeum precision --resume --out /dev/null/x", "do not compare"},
        Misuse{"odeum limits --case nothing --out /dev/null/x", "no case matches"},
        Misuse{"odeum reduction --solver odeum/rk9 --out /dev/null/x", "no solver matches"},
        Misuse{"odeum material --solver bullet/soft_body_lnks --out /dev/null/x",
               "did you mean bullet/soft_body_links?"},
        Misuse{"odeum material --case cloth11_two_way --out /dev/null/x", "--case"},
        Misuse{"odeum converge --jobs 0", "jobs"}, Misuse{"odeum list solver", "solver"},
        Misuse{"odeum stability --grid 1", "grid"}));

TEST_F(CommandLine, TellsThatAStepWasShrunk) {
  const Result result = shell("odeum run free_fall --solver rk4 --step 0.3");
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.output.find("reduced from 0.3"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("7 steps"), std::string::npos) << result.output;
}

TEST_F(CommandLine, NamesTheFilesThatItWrites) {
  const Result some = shell("odeum material --solver odeum/symplectic_euler --out " + in("out")),
               none = shell("odeum cost --solver odeum/symplectic_euler --out " + in("out"));
  EXPECT_NE(some.output.find("hanging_chain"), std::string::npos) << some.output;
  EXPECT_TRUE(fs::exists(fs::path(in("out")) / "material.csv"));
  EXPECT_EQ(none.code, 0) << none.output;
  EXPECT_FALSE(fs::exists(fs::path(in("out")) / "cloth_cost.csv")) << "no engine was chosen";
  EXPECT_EQ(none.output.find("cloth_cost.csv"), std::string::npos) << "named, but not written";
}

TEST_F(CommandLine, AStudyTakesTheNamesOfSolversThatRunTakes) {
  const Result result =
      shell("odeum converge --quick --case free_fall --solver rk4 --out " + in("out"));
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("odeum/rk4"), std::string::npos) << result.output;
  EXPECT_NE(shell("odeum run free_fall --solver closed_form --tol 1e-3").output.find("runs scenes"),
            std::string::npos);
}

TEST_F(CommandLine, ListsInThreeFormats) {
  const auto json = nlohmann::json::parse(shell("odeum list cases --format json").output);
  EXPECT_GE(json.size(), 14U);
  EXPECT_TRUE(shell("odeum list solvers --format csv").output.starts_with("schema,id,"));
  const std::string table = shell("odeum list solvers").output;
  EXPECT_NE(table.find("odeum/rk4"), std::string::npos);
  // A setting of 120 characters put what a solver needs 227 characters from the left.
  EXPECT_LT(table.substr(0, table.find('\n')).size(), 180U);
}

TEST_F(CommandLine, AFailedSolveIsThree) {
  const Result result =
      shell("odeum run dahlquist_real --solver implicit_euler_fixed_point --step 2");
  EXPECT_EQ(result.code, 3) << result.output;
  EXPECT_NE(result.output.find("newton_failed"), std::string::npos) << result.output;
}

TEST_F(CommandLine, FilesThatCannotBeWrittenAreFour) {
  EXPECT_EQ(shell("odeum list solvers > /dev/full").code, 4);
  EXPECT_EQ(shell("odeum run free_fall --solver rk4 --step 0.5 --out /dev/null/x").code, 4);
  const record::OutputFolder held(in("held"));
  const Result result = shell("odeum run free_fall --solver rk4 --step 0.5 --out " + in("held"));
  EXPECT_EQ(result.code, 4);
  EXPECT_NE(result.output.find("in use by"), std::string::npos) << result.output;
}

// The signal of that limit ended the program, and a part of the file stayed there.
TEST_F(CommandLine, ALimitOfFileSizesIsFourAndLeavesNothing) {
  const Result result = shell(
      "ulimit -f 2; odeum run free_fall --solver rk4 --step 0.001 --every 0.001 --out " + in("x"));
  EXPECT_EQ(result.code, 4) << result.output;
  EXPECT_NE(result.output.find("File too large"), std::string::npos) << result.output;
  for (const auto& entry : std::filesystem::directory_iterator(in("x")))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

constexpr const char* study =
    "odeum converge --case 'dahlquist*' --case lotka_volterra --solver 'odeum/*' ";

TEST_F(CommandLine, ResultsDoNotDependOnTheNumberOfJobs) {
  ASSERT_EQ(shell(study + ("--no-cache --quick --jobs 1 --out " + in("one"))).code, 0);
  ASSERT_EQ(shell(study + ("--no-cache --quick --jobs 3 --out " + in("three"))).code, 0);
  for (const char* file : {"convergence.csv", "convergence_times.csv.gz", "orders.csv"}) {
    EXPECT_FALSE(read(folder_ / "one" / file).empty());
    EXPECT_EQ(read(folder_ / "one" / file), read(folder_ / "three" / file)) << file;
  }
}

TEST_F(CommandLine, GoesOnAfterAKillToTheSameBytes) {
  ASSERT_EQ(shell(study + ("--no-cache --quick --out " + in("whole"))).code, 0);
  // Killed as soon as there are kept results, of some two hundred.
  const std::string cache = "XDG_CACHE_HOME=" + in("cache") + " ";
  shell(cache +
        "'" ODEUM_BINARY
        "' converge --case 'dahlquist*' --case lotka_volterra --solver 'odeum/*' --quick --jobs 1 "
        "--out " +
        in("killed") + " & run=$!; until [ $(cat " + in("cache") +
        "/odeum/results/* 2>/dev/null | wc -l) -ge 9 ] || ! kill -0 $run; do sleep 0.01; done; "
        "kill -KILL $run; wait $run");
  ASSERT_FALSE(fs::exists(folder_ / "killed" / "orders.csv")) << "killed too late";
  const Result result =
      shell("export " + cache + "; " + study + "--quick --resume --out " + in("killed"));
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("reused "), std::string::npos);
  for (const char* file : {"convergence.csv", "convergence_times.csv.gz", "orders.csv"})
    EXPECT_EQ(read(folder_ / "whole" / file), read(folder_ / "killed" / file)) << file;
}

TEST_F(CommandLine, KeptResultsAreThoseOfTheSameSettings) {
  const std::string some =
      "export XDG_CACHE_HOME=" + in("cache") + "; odeum converge lotka_volterra ";
  const auto kept = [&](const std::string& options) {
    const Result result = shell(some + options + " --out " + in("out"));
    EXPECT_EQ(result.code, 0) << result.output;
    std::smatch found;
    const std::regex sentence("reused ([0-9]+ of [0-9]+) results from");
    return std::regex_search(result.output, found, sentence) ? found[1].str() : "none";
  };
  EXPECT_EQ(kept("--solver heun --mode fixed --quick"), "none");
  EXPECT_EQ(kept("--solver heun --mode fixed --quick"), "1 of 1");
  EXPECT_EQ(kept("--solver heun --solver rk4 --mode fixed --quick"), "1 of 2") << "by pairs";
  EXPECT_EQ(kept("--solver heun --mode fixed"), "none") << "other settings";
  EXPECT_EQ(kept("--solver heun --mode fixed --no-cache"), "none");
  EXPECT_NE(shell("odeum converge free_fall --resume --no-cache --out " + in("out")).code, 0);
  // Nothing can be kept there: the run goes on.
  const Result closed = shell(
      "export XDG_CACHE_HOME=/dev/null/x; odeum converge free_fall --solver "
      "heun --quick --out " +
      in("out"));
  EXPECT_EQ(closed.code, 0) << closed.output;
}

Result CommandLine::interrupted(const std::string& words, const std::string& when) const {
  // With job control, without which what runs behind hears no SIGINT.
  return shell("set -m; XDG_CACHE_HOME=" + in("cache") + " '" ODEUM_BINARY "' " + words +
               " --out " + in("out") + " & run=$!; until " + when +
               " || ! kill -0 $run 2>/dev/null; do sleep 0.01; done; kill -INT $run; wait $run; "
               "echo code $?");
}

TEST_F(CommandLine, AnInterruptIs130AndLeavesNoHalfFile) {
  // Long enough to be interrupted anywhere; it is once there are kept results.
  const Result result =
      interrupted("converge --case 'dahlquist*' --case lotka_volterra --solver 'odeum/*' --jobs 1",
                  "[ $(cat " + in("cache") + "/odeum/results/* 2>/dev/null | wc -l) -ge 9 ]");
  EXPECT_NE(result.output.find("code 130"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("the same command continues"), std::string::npos) << result.output;
  EXPECT_FALSE(fs::exists(folder_ / "out" / "convergence.csv"));
}

TEST_F(CommandLine, AnInterruptPromisesNoJournalThatThereIsNot) {
  const Result result = interrupted("precision", "[ -e " + in("out") + "/.lock ]");
  EXPECT_NE(result.output.find("interrupted; no file was written"), std::string::npos)
      << result.output;
  EXPECT_FALSE(fs::exists(folder_ / "out" / "precision.csv"));
}

}  // namespace
}  // namespace odeum::command_line_test
