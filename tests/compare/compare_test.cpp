// SPDX-License-Identifier: BSD-3-Clause
// Two folders of results, with losses planted in one of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "odeum/compare/folders.hpp"
#include "odeum/compare/times.hpp"
#include "odeum/record/output_folder.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::compare_test {
namespace {

namespace fs = std::filesystem;
using compare::Change;
using compare::Differences;

constexpr const char* manifest =
    R"({"odeum": {"version": "1", "revision": "a"}, "options": {"quick": true}, "cpu": "one",
        "build": {"compiler": "GNU 12", "type": "Release", "flags": "-O3"},
        "libraries": [{"name": "gsl", "version": "2.7"}]})";
constexpr const char* table =
    "schema,case,library,solver,mode,step,status,error_max,rhs_evaluations,wall_ns_min,detail\n"
    "1,a,odeum,rk4,fixed,0.1,ok,1e-05,100,5,\n"
    "1,a,odeum,rk4,fixed,0.05,ok,6e-07,200,9,\n"
    "1,b,gsl,rk4,fixed,0.1,over_budget,nan,900,5,\"slow, it is\"\n";
constexpr const char* orders =
    "schema,case,library,solver,verdict,measured_order,reason\n1,a,odeum,rk4,confirmed,3.98,\n";

class Folders : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"old", "new"}) {
      write(folder, "manifest.json", manifest);
      write(folder, "convergence.csv", table);
      write(folder, "orders.csv", orders);
    }
  }
  void write(const std::string& folder, const std::string& file, const std::string& text) {
    fs::create_directories(path(folder));
    write_text(path(folder) / file, text);
  }
  fs::path path(const std::string& folder) const { return folder_.path() / folder; }
  /// In a file of the newer folder, other text in place of some.
  void plant(const std::string& file, const std::string& text, const std::string& other) {
    std::string all = text_of(path("new") / file);
    const std::size_t at = all.find(text);
    ASSERT_NE(at, std::string::npos);
    write("new", file, all.replace(at, text.size(), other));
  }
  Differences differences(const std::vector<std::string>& allowed = {}) const {
    return compare::compare_folders(path("old"), path("new"), allowed);
  }

  const TemporaryFolder folder_;
};

TEST_F(Folders, OfEqualRowsHaveNoDifference) {
  plant("manifest.json", "\"revision\": \"a\"", "\"revision\": \"b\"");
  plant("manifest.json", "2.7", "2.8");
  plant("convergence.csv", "fixed,0.1,ok,1e-05,100,5", "fixed,0.1,ok,1e-05,100,17");  // a time
  plant("convergence.csv", "slow, it is", "it is slow");                              // a sentence
  const Differences found = differences();
  EXPECT_TRUE(found.rows.empty());
  EXPECT_EQ(found.tables, 2U);
  EXPECT_EQ(found.compared, 4U);
  EXPECT_FALSE(found.has_regression());
  EXPECT_EQ(found.versions, (std::vector<std::string>{"its revision is a before and b after",
                                                      "gsl is 2.7 before and 2.8 after"}));
}

struct Planted {
  const char *file, *text, *other;
  const char *run, *quantity;
  Change change;
};

TEST_F(Folders, ShowALossWithItsRun) {
  for (const Planted& each : {
           Planted{"convergence.csv", "6e-07,200", "6e-07,204", "a odeum/rk4 fixed 0.05",
                   "rhs_evaluations", Change::worse},
           Planted{"convergence.csv", "1e-05,100", "9e-06,100", "a odeum/rk4 fixed 0.1",
                   "error_max", Change::better},
           Planted{"convergence.csv", "1e-05,100", "1.0000000000000003e-05,100",
                   "a odeum/rk4 fixed 0.1", "error_max", Change::worse},
           Planted{"convergence.csv", "0.05,ok", "0.05,non_finite", "a odeum/rk4 fixed 0.05",
                   "status", Change::worse},
           Planted{"convergence.csv", "0.1,over_budget", "0.1,ok", "b gsl/rk4 fixed 0.1", "status",
                   Change::better},
           Planted{"orders.csv", "3.98", "2.98", "a odeum/rk4", "measured_order", Change::worse},
           Planted{"orders.csv", "3.98", "nan", "a odeum/rk4", "measured_order", Change::worse},
           Planted{"orders.csv", "confirmed", "lower", "a odeum/rk4", "verdict", Change::worse},
           Planted{"convergence.csv", "1,a,odeum,rk4,fixed,0.05,ok,6e-07,200,9,\n", "",
                   "a odeum/rk4 fixed 0.05", "", Change::missing},
       }) {
    SetUp();
    plant(each.file, each.text, each.other);
    const Differences found = differences();
    ASSERT_EQ(found.rows.size(), 1U) << each.other;
    EXPECT_EQ(found.rows[0].table, each.file);
    EXPECT_EQ(found.rows[0].run, each.run);
    EXPECT_EQ(found.rows[0].quantity, each.quantity);
    EXPECT_STREQ(to_string(found.rows[0].change), to_string(each.change)) << each.other;
    EXPECT_EQ(found.has_regression(), each.change != Change::better) << each.other;
    // A line for its solver allows it, one for another does not.
    EXPECT_FALSE(differences({"* *rk4*"}).has_regression());
    EXPECT_EQ(differences({"* *heun*"}).has_regression(), found.has_regression());
  }
}

TEST_F(Folders, OfOtherConditionsAreRefusedWithTheDifference) {
  const auto fault = [&] {
    try {
      differences();
      return std::string();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  plant("manifest.json", "\"cpu\": \"one\"", "\"cpu\": \"two\"");
  EXPECT_NE(fault().find("cpu is one in the first and two in the second"), std::string::npos);
  SetUp();
  plant("manifest.json", "-O3", "-O2");
  EXPECT_NE(fault().find("build/flags is -O3 in the first and -O2"), std::string::npos);
  SetUp();
  plant("manifest.json", "true", "false");
  EXPECT_NE(fault().find("options"), std::string::npos);
  fs::remove(path("new") / "manifest.json");
  EXPECT_NE(fault().find("got no manifest.json"), std::string::npos);
  SetUp();
  write("new", "orders.csv", "schema,case\n1,a");
  EXPECT_THROW(differences(), record::FileError);
}

TEST_F(Folders, OfAnotherMachineMayDifferByAPart) {
  plant("manifest.json", "\"cpu\": \"one\"", "\"cpu\": \"two\"");
  plant("convergence.csv", "6e-07,200", "6.05e-07,204");
  plant("orders.csv", "3.98", "3.97");
  EXPECT_TRUE(compare::compare_folders(path("old"), path("new"), {}, 0.02).rows.empty());
  const Differences closer = compare::compare_folders(path("old"), path("new"), {}, 0.01);
  ASSERT_EQ(closer.rows.size(), 1U);
  EXPECT_EQ(closer.rows[0].quantity, "rhs_evaluations");
  plant("orders.csv", "confirmed", "lower");
  EXPECT_TRUE(compare::compare_folders(path("old"), path("new"), {}, 0.5).has_regression());
}

// A regression of the whole way: a study's folder, and one in which a number was changed.
TEST(Compare, HasTheExitCodeOfARegression) {
  const TemporaryFolder folder;
  const Result result = shell(fmt::format(
      "cd '{}' && export XDG_CACHE_HOME=$PWD && odeum converge --case osc_under --solver rk4 "
      "--quick "
      "--out a >/dev/null && odeum converge --case osc_under --solver rk4 --quick --no-cache --out "
      "b "
      ">/dev/null && odeum compare a b && sed -i 's/,confirmed,/,lower,/' b/orders.csv && "
      "odeum compare a b --format csv --out c; test $? = 1 && cmp -s c/differences.csv <(odeum "
      "compare a b --format csv) && odeum compare a nowhere; test $? = 2",
      folder.path().string()));
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("0 values differ"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find(",verdict,worse,confirmed,lower,"), std::string::npos)
      << result.output;
}

// The commands move a clock of the test on, by 10 and 50 ms, and by one more in each run.
TEST(Compare, TellsTheSlowerOfTwoCommands) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "clock").string();
  std::size_t runs = 0;
  const auto clock = [&] {
    const double moved = fs::exists(file) ? static_cast<double>(fs::file_size(file)) : 0;
    return 1e-3 * (moved + static_cast<double>(runs++));
  };
  const auto takes = [&](int ms) { return fmt::format("printf '%{}s' >> '{}'", ms, file); };
  const compare::TimesRow row = compare::compare_times(takes(10), takes(50), 11, clock);
  EXPECT_TRUE(row.is_slower(0.03)) << row.ratio << ' ' << row.ratio_low;
  EXPECT_NEAR(row.ratio, 51.0 / 11, 1e-9);
  EXPECT_NEAR(row.before_seconds, 0.011, 1e-12);
  EXPECT_GE(row.ratio_high, row.ratio);
  const compare::TimesRow same = compare::compare_times(takes(10), takes(10), 11, clock);
  EXPECT_FALSE(same.is_slower(0.03)) << same.ratio;
  try {
    compare::compare_times("true", "exit 3", 11);
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "exit 3: exit code 3");
  }
}

// A column twice in a damaged header ended the program.
TEST(Compare, AColumnTwiceIsNoTable) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) {
    fs::create_directory(folder.path() / name);
    write_text(folder.path() / name / "manifest.json", "{\"libraries\": [7]}");
    write_text(folder.path() / name / "x.csv", "schema,nan,,\n1,2,3,4\n");
  }
  EXPECT_THROW(compare::compare_folders(folder.path() / "a", folder.path() / "b", {}, 0),
               record::FileError);
}

}  // namespace
}  // namespace odeum::tests::compare_test
