// SPDX-License-Identifier: BSD-3-Clause
// Plans and parts that are not as they were written: each is refused at once with a sentence.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "odeum/core/checksum.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::damaged_plan_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using tests::Result;
using tests::shell;
using tests::text_of;

std::string sum_of(const std::string& text) { return fmt::format("{:016x}", checksum(text)); }

class DamagedPlan : public ::testing::Test {
 protected:
  DamagedPlan() {
    write("decay.yaml",
          "parameters: {k: 1}\nstates: {x: 1}\nequations: {x: -k*x}\ntime: {end: 2}\n");
    plan("run", "--over k=0.1..3:4");
  }
  void plan(const std::string& run, const std::string& over) const {
    const Result made = odeum("plan sweep decay.yaml " + over +
                              " --solver rk4 --step 0.1 --check 0 --shards 2 --out " + run);
    EXPECT_EQ(made.code, 0) << made.output;
  }
  Result odeum(const std::string& words) const {
    // A command that does not end by itself within 5 s hangs.
    return shell("cd '" + folder_.path().string() + "' && timeout -k 1 100 '" ODEUM_BINARY "' " +
                 words);
  }
  void expect_refused(const std::string& what, const std::string& sentence) const {
    for (const char* words : {"status run", "shard run 0", "merge run --out merged"}) {
      const Result result = odeum(words);
      EXPECT_EQ(result.code, 2) << what << ": " << words << "\n" << result.output;
      EXPECT_NE(result.output.find("plan.json"), std::string::npos) << result.output;
      EXPECT_NE(result.output.find(sentence), std::string::npos) << what << result.output;
    }
  }
  void write(const fs::path& file, const std::string& text) const {
    std::ofstream(folder_.path() / file) << text;
  }
  std::string text(const fs::path& file) const { return text_of(folder_.path() / file); }

  /// Replaces what a shard has kept of its members, with sums that are right again.
  void forge(const fs::path& shard, const std::function<void(std::string& result)>& change) const {
    const fs::path at = folder_.path() / shard;
    auto json = ordered_json::parse(text_of(at / "shard.json"));
    for (auto& [name, file] : json.at("files").items()) {
      std::string forged;
      std::istringstream in(text_of(at / "results" / name));
      for (std::string line; std::getline(in, line);) {
        std::string result = line.substr(line.find('\t') + 1);
        if (result.find("members ") != std::string::npos) change(result);
        forged += sum_of(result) + '\t' + result + '\n';
      }
      write(shard / "results" / name, forged);
      file = {{"bytes", forged.size()}, {"sum", sum_of(forged)}};
    }
    write(shard / "shard.json", json.dump(2) + "\n");
  }

  tests::TemporaryFolder folder_;
};

// A plan whose words were changed merged to the rows of another command.
TEST_F(DamagedPlan, IsRefusedWhateverOfItChanged) {
  const std::string good = text("run/plan.json");
  const std::map<std::string, ordered_json> changes{
      {"id", "../../x"},
      {"program", "another"},
      {"content", "another"},
      {"folder", "/"},
      {"words", {"sweep", "decay.yaml", "--over", "k=5,6", "--solver", "heun", "--step", "0.1"}},
      {"first_alone", 1},
      {"foreseen_seconds", {1, 2}},
      {"shard_of_task", "0 0 0 1"}};
  for (const auto& [key, value] : changes) {
    ordered_json changed = ordered_json::parse(good);
    changed[key] = value;
    write("run/plan.json", changed.dump());
    expect_refused(key, "plan anew");
  }
  for (const char* shards : {"1e18", "1000000000000000000", "-1", "0", "3", "2.5", "\"two\""}) {
    ordered_json changed = ordered_json::parse(good);
    changed["shards"] = ordered_json::parse(shards);
    write("run/plan.json", changed.dump());
    expect_refused(shards, "plan anew");
  }
  for (const std::string& other : {std::string(), good.substr(0, good.size() / 2),
                                   std::string("[1, 2]"), std::string(100'000, '[')}) {
    write("run/plan.json", other);
    expect_refused(other.substr(0, 20), "is damaged");
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "x"));
}

TEST_F(DamagedPlan, IsRefusedAtOnceWhereItIsNotAFile) {
  const fs::path file = folder_.path() / "run/plan.json";
  fs::remove(file);
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  expect_refused("a FIFO", "got a FIFO");
  fs::remove(file);
  fs::create_symlink("/dev/zero", file);
  expect_refused("/dev/zero", "got a device");
  fs::remove(file);
  fs::create_directory(file);
  expect_refused("a folder", "got a directory");
  fs::remove(file);
  write("run/plan.json", "");
  fs::resize_file(file, 1ULL << 40U);  // a hole
  expect_refused("a large file", "too large");
}

TEST_F(DamagedPlan, AShardOfAnotherPlanIsNotTaken) {
  plan("other", "--over k=0.1..4:4");
  for (const char* run : {"run", "other"})
    for (const char* shard : {" 0", " 1"})
      EXPECT_EQ(odeum(std::string("shard ") + run + shard).code, 0);
  fs::rename(folder_.path() / "run/shards/0", folder_.path() / "kept");
  fs::copy(folder_.path() / "other/shards/0", folder_.path() / "run/shards/0",
           fs::copy_options::recursive);
  Result merged = odeum("merge run --out merged");
  EXPECT_EQ(merged.code, 1);
  EXPECT_NE(merged.output.find("missing shard 0: is of another plan"), std::string::npos);
  fs::remove_all(folder_.path() / "run/shards/0");
  fs::copy(folder_.path() / "run/shards/1", folder_.path() / "run/shards/0",
           fs::copy_options::recursive);
  merged = odeum("merge run --out merged");
  EXPECT_EQ(merged.code, 1);
  EXPECT_NE(merged.output.find("missing shard 0: has the results of another shard"),
            std::string::npos);
  fs::remove_all(folder_.path() / "run/shards/0");
  ASSERT_EQ(::mkfifo((folder_.path() / "run/shards/1/shard.json.fifo").c_str(), 0600), 0);
  fs::rename(folder_.path() / "run/shards/1/shard.json.fifo",
             folder_.path() / "run/shards/1/shard.json");
  EXPECT_EQ(odeum("status run").code, 1) << "a FIFO in place of shard.json does not hang";
}

// More rows than members were written behind the results of all; fewer lost a member in silence.
TEST_F(DamagedPlan, APartHasTheRowsOfItsMembers) {
  for (const char* shard : {"shard run 0", "shard run 1"}) EXPECT_EQ(odeum(shard).code, 0);
  const std::string all = text("run/shards/0/shard.json");
  fs::copy(folder_.path() / "run/shards/0", folder_.path() / "kept", fs::copy_options::recursive);
  const std::string line_end = "\\n";  // as the store escapes it
  const auto last_row = [&](const std::string& result) {
    const std::size_t end = result.size() - line_end.size();
    return result.rfind(line_end, end - 1) + line_end.size();
  };
  const auto number = [](std::string& result, const std::string& from, const std::string& to) {
    result.replace(result.rfind(from), from.size(), to);
  };
  const std::vector<std::pair<const char*, std::function<void(std::string&)>>> forgeries{
      {"more rows",
       [&](std::string& result) {
         const std::string row = result.substr(last_row(result));
         for (int k = 0; k < 2000; ++k) result += row;
       }},
      {"fewer rows", [&](std::string& result) { result.erase(last_row(result)); }},
      {"another member", [&](std::string& result) { result[last_row(result) + 2] ^= 1; }},
      {"no number", [&](std::string& result) { number(result, ",ok,,", ",ok,,x"); }},
      {"no columns", [&](std::string& result) { number(result, ",ok,", ""); }},
      {"more solved", [&](std::string& result) { result.insert(result.find('\t') + 1, "9"); }},
      {"nothing", [&](std::string& result) { result.erase(result.find('\t') + 1); }},
  };
  for (const auto& [what, change] : forgeries) {
    fs::remove_all(folder_.path() / "run/shards/0");
    fs::copy(folder_.path() / "kept", folder_.path() / "run/shards/0", fs::copy_options::recursive);
    forge("run/shards/0", change);
    const Result merged = odeum("merge run --out merged");
    EXPECT_EQ(merged.code, 2) << what << "\n" << merged.output;
    EXPECT_NE(merged.output.find("in the shards is damaged"), std::string::npos)
        << what << merged.output;
  }
}

}  // namespace
}  // namespace odeum::damaged_plan_test
