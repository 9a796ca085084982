// SPDX-License-Identifier: BSD-3-Clause
// odeum plan, shard, merge and status as a user runs them.
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::plan_test {
namespace {

using tests::Result;
using tests::shell;
using tests::TemporaryFolder;
using tests::text_of;

constexpr const char* decay =
    "parameters: {k: 1}\nstates: {x: 1}\nequations: {x: -k*x}\ntime: {end: 2}\n";

class Plan : public ::testing::Test {
 protected:
  Result odeum(const std::string& words) const {
    return shell("cd " + folder_.path().string() + " && odeum " + words);
  }
  void expect_code(int code, const std::string& words, const std::string& part = "") const {
    const Result result = odeum(words);
    EXPECT_EQ(result.code, code) << words << "\n" << result.output;
    EXPECT_NE(result.output.find(part), std::string::npos) << words << "\n" << result.output;
  }
  std::string text(const std::string& file) const { return text_of(folder_.path() / file); }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_.path() / file) << text;
  }

  TemporaryFolder folder_;
};

TEST_F(Plan, OfASweepMergesToTheBytesOfOneRun) {
  write("decay.yaml", decay);
  const std::string words =
      "sweep decay.yaml --over k=0.1..3:30 --solver rk4 --step 0.1 --check 0 --until 2 ";
  expect_code(0, words + "--out one");
  expect_code(0, "plan " + words + "--shards 4 --out run", "30 tasks in 4 shards");
  expect_code(1, "status run", "0 of 4 done");
  for (const char* shard : {"2", "0", "1", "2"}) expect_code(0, std::string("shard run ") + shard);
  expect_code(1, "status run", "3 of 4 done");
  expect_code(1, "merge run --out merged --resubmit", "missing shard 3: was not run");
  EXPECT_NE(text("run/resubmit.sh").find("these 3\n"), std::string::npos);
  expect_code(0, "shard run 3");
  expect_code(0, "merge run --out merged", "solved    30");
  EXPECT_EQ(text("merged/members.csv"), text("one/members.csv"));
  EXPECT_FALSE(text("one/members.csv").empty());

  for (const auto& entry :
       std::filesystem::directory_iterator(folder_.path() / "run/shards/1/results")) {
    std::string content = text_of(entry.path());
    content[content.size() / 2] ^= 1;
    std::ofstream(entry.path()) << content;
  }
  expect_code(1, "merge run --out merged", "missing shard 1: ");
  expect_code(0, "shard run 1", "it is run again");
  expect_code(0, "merge run --out again");
  EXPECT_EQ(text("again/members.csv"), text("one/members.csv"));

  write("decay.yaml", std::string(decay) + "# another content\n");
  expect_code(2, "merge run --out merged", "has changed since the plan");
}

// A folder of a name that can be foretold could be prepared by another user, with code in it.
TEST_F(Plan, AShardWorksInANewFolderAndLeavesNone) {
  write("decay.yaml", decay);
  expect_code(0,
              "plan sweep decay.yaml --over k=0.1..3:4 --solver rk4 --step 0.1 --check 0 "
              "--shards 2 --out run");
  const std::string plan = text("run/plan.json");
  const std::size_t begin = plan.find("\"id\": \"") + 7;
  const std::string id = plan.substr(begin, plan.find('"', begin) - begin);
  const std::filesystem::path temporary = folder_.path() / "tmp",
                              prepared =
                                  temporary / fmt::format("odeum-{}-{}/odeum", ::geteuid(), id);
  std::filesystem::create_directories(prepared);
  const auto shard = [&](const std::string& k) {
    const Result result =
        shell("cd " + folder_.path().string() + " && TMPDIR=$PWD/tmp odeum shard run " + k);
    EXPECT_EQ(result.code, 0) << result.output;
    EXPECT_TRUE(std::filesystem::is_empty(prepared));
    std::filesystem::directory_iterator entries(temporary);
    EXPECT_EQ(std::distance(entries, {}), 1) << "only the prepared folder stays";
  };
  shard("0");
  shard("1");
}

TEST_F(Plan, OfAStudyMergesToTheBytesOfOneRun) {
  const std::string words =
      "converge --case lotka_volterra --solver rk4 --solver heun --solver 'gsl/rk8pd' --quick ";
  expect_code(0, words + "--no-cache --out one");
  expect_code(0, "plan " + words + "--shards 2 --out run", "in 2 shards");
  expect_code(0, "shard run 0");
  expect_code(0, "shard run 1");
  expect_code(0, "merge run --out merged");
  for (const char* file : {"convergence.csv", "orders.csv"}) {
    EXPECT_EQ(text(std::string("merged/") + file), text(std::string("one/") + file)) << file;
    EXPECT_FALSE(text(std::string("one/") + file).empty()) << file;
  }
}

// The files of earlier runs are not touched, and rows but for times are those of one run.
TEST_F(Plan, OfATimedStudyKeepsEachCaseInOneShard) {
  const std::string words =
      "precision --case kepler_e06 --case dahlquist_real --solver rk4 --seconds 0.05 ";
  expect_code(0, "plan " + words + "--shards 2 --out run", "2 tasks in 2 shards");
  EXPECT_NE(text("run/submit.sh").find("how=--exclusive\nrange 0 2\n"), std::string::npos);
  expect_code(0, "shard run 0");
  expect_code(0, "shard run 1");
  expect_code(0, "merge run --out merged");
  const std::string rows = text("merged/precision.csv");
  for (const char* id : {",kepler_e06,", ",dahlquist_real,"})
    EXPECT_NE(rows.find(id), std::string::npos) << rows;
  EXPECT_NE(rows.find(",processor\n"), std::string::npos);
}

TEST_F(Plan, OfAReportMergesToTheBytesOfOneRunButForTimes) {
  write("decay.yaml", decay);
  const std::string words = "report decay.yaml --quick --no-cache --solver rk4 --solver heun ";
  expect_code(0, words + "--out one");
  expect_code(0, "plan " + words + "--shards 2 --out run", "in 2 shards");
  EXPECT_NE(text("run/submit.sh").find("how=--exclusive\nrange 1 2\n"), std::string::npos)
      << "the timed runs are one comparison, in a shard of its own";
  for (const char* shard : {"0", "1"}) expect_code(0, std::string("shard run ") + shard);
  expect_code(0, "merge run --out merged", "merged/index.html");
  for (const char* file : {"convergence.csv", "orders.csv", "drift.csv"}) {
    EXPECT_EQ(text(std::string("merged/") + file), text(std::string("one/") + file)) << file;
    EXPECT_FALSE(text(std::string("one/") + file).empty()) << file;
  }
  EXPECT_NE(text("merged/precision.csv").find(",heun,"), std::string::npos);
}

TEST_F(Plan, StudiesOfMembersMergeToTheBytesOfOneRun) {
  write("decay.yaml", decay);
  const std::string words =
      "sweep decay.yaml --over k=0.5..3:5 --study converge --solver rk4 --solver heun ";
  expect_code(0, words + "--out one", "confirmed");
  expect_code(0, "plan " + words + "--shard-time 1h --out run", "10 tasks in 1 shards");
  expect_code(0, "plan " + words + "--shards 3 --out more", "10 tasks in 3 shards");
  for (const char* shard : {"0", "1", "2"}) expect_code(0, std::string("shard more ") + shard);
  expect_code(0, "merge more --out merged");
  EXPECT_EQ(text("merged/members.csv"), text("one/members.csv"));
  EXPECT_NE(text("one/members.csv").find("odeum/heun,3,ok,confirmed"), std::string::npos);
}

TEST_F(Plan, AMergeWaitsForNamesThatAreShownLate) {
  write("decay.yaml", decay);
  expect_code(0,
              "plan sweep decay.yaml --over k=1,2 --solver rk4 --step 0.1 --check 0 --shards 1 "
              "--out run");
  expect_code(0, "shard run 0");
  std::filesystem::rename(folder_.path() / "run/shards/0", folder_.path() / "late");
  const Result late = shell("cd " + folder_.path().string() +
                            " && (sleep 0.3; mv late run/shards/0) & odeum merge " +
                            (folder_.path() / "run").string());
  EXPECT_EQ(late.code, 0) << late.output;
}

TEST_F(Plan, AShardWhoseResultsAreNotKeptFails) {
  write("decay.yaml", decay);
  expect_code(
      0,
      "plan sweep decay.yaml --over k=0.1..3:60 --solver rk4 --step 0.1 --check 0 --shards 1 "
      "--out run");
  const Result full =
      shell("cd " + folder_.path().string() + " && ulimit -f 1 && odeum shard run 0");
  EXPECT_EQ(full.code, 4) << full.output;
  EXPECT_NE(full.output.find("could not be kept"), std::string::npos) << full.output;
  expect_code(1, "merge run", "missing shard 0: is unfinished");
  expect_code(0, "shard run 0");
  expect_code(0, "merge run --out merged", "solved    60");
}

TEST_F(Plan, BadInputHasItsSentence) {
  write("decay.yaml", decay);
  expect_code(2, "plan --shards 2 --out run", "no command");
  expect_code(2, "plan advise kepler_e06 --shards 2 --out run", "advise cannot be done in shards");
  expect_code(2, "plan converge --out run", "--shards or --shard-time");
  expect_code(2, "plan converge --shard-time soon --out run", "in h, min, s or ms");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "run")) << "refused before it is made";
  expect_code(2, "plan converge --case nothing_like_it --shards 2 --out run");
  expect_code(2, "sweep decay.yaml --over k=1,2 --study advise", "needs --error");
  expect_code(2, "sweep decay.yaml --over k=1,2 --study converge", "--solver is required");
  expect_code(2, "sweep decay.yaml --over k=1,2 --study converge --solver rk4 --tol 1e-3",
              "chooses its settings");
  expect_code(2, "shard run 0", "no plan.json");
  expect_code(0, "plan sweep decay.yaml --over k=1,2 --solver rk4 --step 0.1 --shards 9 --out run",
              "2 tasks in 2 shards");
  expect_code(2, "shard run 2", "the plan has shards 0 to 1");
  expect_code(2, "merge nowhere");
  std::filesystem::create_directory(folder_.path() / "bad");
  write("bad/plan.json", R"({"id": "x", "program": "a", "content": "b", "folder": "c", "words": [],
                             "shards": 1, "first_alone": 0, "shard_of_task": "0 -4 two"})");
  expect_code(2, "status bad", "bad/plan.json is damaged");
}

}  // namespace
}  // namespace odeum::plan_test
