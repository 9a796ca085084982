// SPDX-License-Identifier: BSD-3-Clause
// Faults of the surroundings, told before the work, and work that nobody asked for.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "support/gmsh_text.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::faults_test {
namespace {

namespace fs = std::filesystem;
using tests::Result;
using tests::shell;

class Faults : public testing::Test {
 protected:
  Faults() {
    write("decay.yaml",
          "parameters: {k: 1}\nstates: {x: 1}\nequations: {x: -k*x}\ntime: {end: 2}\n");
    write("square.msh", tests::gmsh_square);
    write("file", "");
  }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_.path() / file) << text;
  }
  Result run(const std::string& command) const {
    return shell("cd '" + folder_.path().string() + "' && " + command);
  }
  tests::TemporaryFolder folder_;
};

TEST_F(Faults, AFolderThatCannotBeMadeIsToldBeforeTheWork) {
  for (const char* words :
       {"run decay.yaml --solver rk4 --step 0.1", "run lotka_volterra --solver rk4 --step 0.1",
        "run spinning_pair --until 0.1", "why lotka_volterra --solver rk4 --step 0.1",
        "advise lotka_volterra --error 1e-3",
        "sweep lotka_volterra --over a=1,2 --solver rk4 --step 1",
        "converge lotka_volterra --solver rk4", "precision --case lotka_volterra --solver rk4",
        "stability --solver rk4", "report --quick --case lotka_volterra --solver rk4",
        "classify 1 0 y", "poisson square.msh --load 1", "plan converge --shards 2"}) {
    const Result result = run(std::string("odeum ") + words + " --out file/x");
    EXPECT_EQ(result.code, 4) << words << "\n" << result.output;
    EXPECT_TRUE(result.output.starts_with("odeum: cannot make folder file/x: Not a directory\n"))
        << words << "\n"
        << result.output;
  }
}

TEST_F(Faults, ATruthIsComputedWhereItIsAskedForAlone) {
  const auto references = [&](const std::string& words) {
    const fs::path cache = folder_.path() / "cache";
    fs::remove_all(cache);
    const Result result = run("export XDG_CACHE_HOME=$PWD/cache; odeum " + words);
    EXPECT_EQ(result.code, 0) << words << "\n" << result.output;
    return std::ranges::count_if(fs::recursive_directory_iterator(cache), [](const auto& entry) {
      return entry.path().extension() == ".reference";
    });
  };
  const std::string sweep = "sweep decay.yaml --over k=1,2 --solver rk4 --step 0.1 --check ";
  EXPECT_EQ(references("list solvers decay.yaml"), 0);
  EXPECT_EQ(references("run decay.yaml --solver rk4 --step 0.1 --code"), 0);
  EXPECT_EQ(references("run decay.yaml --solver rk4 --step 0.1 --no-truth"), 0);
  EXPECT_EQ(references(sweep + "0"), 0);
  EXPECT_GT(references(sweep + "2"), 0) << "else it tests nothing";
}

// Slurm's number is the site's: it does not make more threads than there are cores.
TEST_F(Faults, ThreadsAreAtMostTheCores) {
  const Result result = run(
      "SLURM_CPUS_PER_TASK=100000 odeum sweep decay.yaml --over k=1..2:200 --solver rk4 --step 0.1 "
      "--check 0");
  EXPECT_EQ(result.code, 0) << result.output;
  const std::size_t at = result.output.find(" on ");
  ASSERT_NE(at, std::string::npos) << result.output;
  EXPECT_LE(std::stoul(result.output.substr(at + 4)), std::thread::hardware_concurrency());
}

}  // namespace
}  // namespace odeum::faults_test
