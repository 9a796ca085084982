// SPDX-License-Identifier: BSD-3-Clause
// Commands whose standard output or standard error is closed, full, or read by nobody.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::standard_streams_test {
namespace {

namespace fs = std::filesystem;
using tests::Result;
using tests::shell;

/// A quick run of each command, in a folder of its own.
constexpr const char* commands[] = {
    "list solvers",
    "doctor",
    "--help",
    "no_such_command",
    "run free_fall --solver rk4 --step 0.1",
    "run spring_explicit_euler --solver explicit_euler --step 0.05 --until 1 --no-truth --out out",
    "run no_such_case --solver rk4 --step 0.1",
    "converge free_fall --solver rk4 --solver heun --quick --out out",
    "stability free_fall --solver heun --out out",
    "drift kepler_e06 --solver rk4 --out out",
    "precision dahlquist_real --solver rk4 --seconds 0.05 --out out",
    "advise dahlquist_real --error 1e-3 --solver odeum/rk4 --seconds 600",
    "why dahlquist_real --solver odeum/rk4 --step 0.1",
    "sweep lotka_volterra --over a=1,1.5 --solver rk4 --step 0.1 --out out",
    "plan converge free_fall --solver rk4 --quick --shards 1 --out plan",
    "verify no_such_file.yaml",
    "completion bash",
    "help run",
    "classify 1 0 1",
    "poisson no_such_file.msh --load 1",
    "shard nowhere 0",
    "merge nowhere",
    "status nowhere",
    "report --case nothing_like_it",
    "limits --solver nothing_like_it",
    "reduction --solver nothing_like_it",
    "material --solver nothing_like_it",
    "cloth --solver nothing_like_it",
    "cost --solver nothing_like_it",
    "mesh --solver nothing_like_it",
    "elements --problem nothing_like_it",
    "evolution --solver nothing_like_it",
    "proof --solver nothing_like_it",
    "judge osc_under nothing_like_it.csv",
    "compare nothing_like_it nothing_like_it",
};

TEST(StandardStreamsList, HasEveryCommand) {
  std::istringstream help(shell("odeum --help").output);
  const std::regex entry("  ([a-z]+)  +[a-z].*");
  std::size_t found = 0;
  std::smatch match;
  for (std::string line; std::getline(help, line);) {
    if (!std::regex_match(line, match, entry)) continue;
    ++found;
    const std::string name = match[1];
    EXPECT_TRUE(std::ranges::any_of(commands, [&](const std::string& command) {
      return command.starts_with(name);
    })) << name;
  }
  EXPECT_GE(found, 25U);
}

class StandardStreams : public testing::TestWithParam<const char*> {
 protected:
  /// The exit code of the command with these redirections, the last word of what is printed.
  int code(const std::string& redirections) const {
    const Result result =
        shell("cd '" + folder_.path().string() + "' && rm -rf out plan && { (odeum " + GetParam() +
              " " + redirections + "); echo \"code $?\"; }");
    const std::size_t at = result.output.rfind("code ");
    return at == std::string::npos ? -1 : std::stoi(result.output.substr(at + 5));
  }
  void expect_no_output_in_files() const {
    for (const char* name : {"out/.lock", "plan/.lock"}) {
      const fs::path lock = folder_.path() / name;
      EXPECT_LT(fs::exists(lock) ? fs::file_size(lock) : 0, 200U) << name << " has a table";
    }
  }
  tests::TemporaryFolder folder_;
};

TEST_P(StandardStreams, AnErrorThatNobodyReadsEndsNoCommand) {
  const int right = code("2>/dev/null");
  EXPECT_LT(right, 5);
  EXPECT_EQ(code("2>/dev/full"), right);
  EXPECT_EQ(code("2>&-"), right);
  expect_no_output_in_files();
}

TEST_P(StandardStreams, AClosedOutputIsAnErrorOfWriting) {
  constexpr int file_failed = 4;
  const int right = code("2>/dev/null");
  const bool prints = shell("cd '" + folder_.path().string() + "' && rm -rf out plan; odeum " +
                            GetParam() + " 2>/dev/null")
                          .output.size() > 0;
  for (const char* closed : {">&-", ">&- 2>&-", "<&- >&- 2>&-"})
    EXPECT_EQ(code(closed), prints ? file_failed : right) << closed;
  expect_no_output_in_files();
}

INSTANTIATE_TEST_SUITE_P(Each, StandardStreams, testing::ValuesIn(commands));

TEST(ClosedPipe, IsQuiet) {
  const Result result =
      shell("odeum list solvers --format json | head -n 1; echo ${PIPESTATUS[0]}");
  EXPECT_EQ(result.output, "[\n0\n");
}

TEST(ClosedPipe, KeepsFilesAndExitCode) {
  const tests::TemporaryFolder folder;
  // `true` has ended when the program starts: its first line finds the pipe closed.
  const auto unread = [](const std::string& command) {
    return shell("{ sleep 0.2; " + command + "; } | true; echo ${PIPESTATUS[0]}").output;
  };
  EXPECT_EQ(unread("odeum run free_fall --solver rk4 --step 0.5 --out " +
                   (folder.path() / "one").string()),
            "0\n");
  EXPECT_TRUE(fs::exists(folder.path() / "one" / "index.html"));
  EXPECT_EQ(
      unread("odeum run spinning_pair --until 0.5 --out " + (folder.path() / "scene").string()),
      "0\n");
  EXPECT_TRUE(fs::exists(folder.path() / "scene" / "replay.html"));
  EXPECT_EQ(unread("odeum run dahlquist_real --solver implicit_euler_fixed_point --step 2"), "3\n");
}

}  // namespace
}  // namespace odeum::standard_streams_test
