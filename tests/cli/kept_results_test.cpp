// SPDX-License-Identifier: BSD-3-Clause
// Results that are kept between runs: what of a program must change for a result to be measured
// again. The program is altered where its build writes the hashes of its object files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests {
namespace {

namespace fs = std::filesystem;

/// The units of a table that scripts/cmake/HashUnits.cmake wrote, and their hashes.
std::map<std::string, std::string> units_in(const fs::path& table) {
  std::map<std::string, std::string> units;
  const std::string text = text_of(table);
  const std::regex row("\\{\"([^\"]+)\", \"([0-9a-f]{64})\"\\}");
  for (std::sregex_iterator each(text.begin(), text.end(), row), end; each != end; ++each)
    units[(*each)[1]] = (*each)[2];
  return units;
}

/// Object files with the paths of a build, each with a text of its own.
class Objects {
 public:
  explicit Objects(const std::vector<std::string>& paths) {
    std::string list;
    for (const std::string& path : paths) {
      const fs::path file = folder_.path() / path;
      fs::create_directories(file.parent_path());
      write_text(file, "object of " + path);
      list += file.string() + "\n";
    }
    write_text(folder_.path() / "objects.txt", list);
  }
  void change_a_byte(const std::string& path) const {
    std::string text = text_of(folder_.path() / path);
    ++text.back();
    write_text(folder_.path() / path, text);
  }
  std::map<std::string, std::string> units() const {
    const std::string at = folder_.path().string();
    const Result result =
        shell("cmake -DOBJECTS=" + at + "/objects.txt -DOUTPUT=" + at +
              "/units.cpp -P '" ODEUM_SOURCE_DIR "/scripts/cmake/HashUnits.cmake'");
    EXPECT_EQ(result.code, 0) << result.output;
    return units_in(folder_.path() / "units.cpp");
  }

 private:
  TemporaryFolder folder_;
};

TEST(HashedUnits, ChangeWithTheirOwnObjectsAlone) {
  using Units = std::set<std::string>;
  const std::map<std::string, Units> units_of{
      {"odeum_methods.dir/generated/own/rk.cpp.o", {"own/rk"}},
      {"odeum_methods.dir/generated/own/heun-kutta.cpp.o", {"own/heun", "own/kutta"}},
      {"adapters/gsl/odeum_adapter_gsl.dir/solve.cpp.o", {"adapter/gsl"}},
      {"adapters/gsl/odeum_adapter_gsl.dir/catalogue.cpp.o", {"adapter/gsl"}},
      {"odeum_cases.dir/cases/pleiades.cpp.o", {"case/pleiades"}},
      {"odeum_cases.dir/generated/cases/robertson.cpp.o", {"case/robertson"}},
      {"odeum_cases.dir/src/odeum/cases/stage.cpp.o", {"rest"}},
      {"odeum_once.dir/Unity/unity_judge_a_cxx.cxx.o", {"rest"}},
      {"odeum_study.dir/src/odeum/studies/runner.cpp.o", {"rest"}},
      {"odeum_study.dir/Unity/unity_pages_studies_drift_a_cxx.cxx.o", {}},
      {"odeum_study.dir/src/odeum/report/report.cpp.o", {}},
      {"odeum_study.dir/src/odeum/studies/drift/study.cpp.o", {}},
      {"odeum_study.dir/src/odeum/studies/study.cpp.o", {"rest"}},
      {"odeum_core.dir/src/odeum/solvers/own_methods.cpp.o", {}},
      {"odeum_plain.dir/src/odeum/proof/facts.cpp.o", {}},
      {"odeum_cases.dir/src/odeum/cases/all_cases.cpp.o", {}}};
  std::vector<std::string> paths;
  for (const auto& [path, units] : units_of) paths.push_back(path);
  const Objects objects(paths);
  auto before = objects.units();
  EXPECT_EQ(before.size(), 7U);
  EXPECT_NE(before.at("own/heun"), before.at("own/kutta"));  // results know whose they are
  for (const auto& [path, changed] : units_of) {
    objects.change_a_byte(path);
    const auto after = objects.units();
    ASSERT_EQ(after.size(), before.size()) << path;
    for (const auto& [unit, hash] : after)
      EXPECT_EQ(hash != before.at(unit), changed.contains(unit)) << path << ' ' << unit;
    before = after;
  }
}

/// The built program beside copies of it, one for each unit, that differ in the hash of that unit:
/// what an edit of its sources comes to.
class Kept : public testing::Test {
 protected:
  static constexpr const char* study =
      " converge free_fall --quick --jobs 1 --solver rk4 heun verner98";

  void SetUp() override {
    units_ = units_in(fs::path(ODEUM_BINARY).parent_path() / "generated/odeum_units.cpp");
    ASSERT_FALSE(units_.empty());
    program_ = text_of(ODEUM_BINARY);
    results_ = rows_of(run(ODEUM_BINARY, folder_.path() / "cache", study));
    ASSERT_GE(results_, 6U);
  }

  Result run(const fs::path& program, const fs::path& cache, const std::string& arguments) const {
    return shell("XDG_CACHE_HOME='" + cache.string() + "' '" + program.string() + "'" + arguments +
                 " --out '" + (cache / "out").string() + "'");
  }
  /// The rows of the table of orders, one for each result.
  static std::size_t rows_of(const Result& result) {
    EXPECT_EQ(result.code, 0) << result.output;
    std::size_t rows = 0;
    for (std::size_t at = 0; (at = result.output.find("\nfree_fall ", at)) != std::string::npos;
         ++at)
      ++rows;
    return rows;
  }
  static std::size_t taken(const Result& result) {
    std::smatch found;
    const std::regex sentence("([0-9]+) of ([0-9]+) results are those of earlier runs");
    return std::regex_search(result.output, found, sentence) ? std::stoul(found[1]) : 0;
  }
  /// How many results a program measures again that differs in this unit.
  std::size_t measured_again(const std::string& unit) {
    std::string altered = program_;
    const std::size_t at = altered.find(units_.at(unit));
    EXPECT_NE(at, std::string::npos) << unit;
    EXPECT_EQ(altered.find(units_.at(unit), at + 1), std::string::npos) << unit;
    altered[at] = altered[at] == '0' ? '1' : '0';
    const fs::path program = folder_.path() / "altered", cache = folder_.path() / "copy";
    write_text(program, altered);
    fs::permissions(program, fs::perms::owner_all);
    fs::remove_all(cache);
    fs::copy(folder_.path() / "cache", cache, fs::copy_options::recursive);
    return results_ - taken(run(program, cache, study));
  }

  TemporaryFolder folder_;
  std::map<std::string, std::string> units_;
  std::string program_;
  std::size_t results_ = 0;
};

TEST_F(Kept, AnEditedMethodMeasuresItsFamilyAgain) {
  const std::size_t each = results_ / 3;  // of the three solvers, in both modes
  EXPECT_EQ(taken(run(ODEUM_BINARY, folder_.path() / "cache", study)), results_) << "no edit";
  for (const char* own : {"own/rk", "own/heun", "own/verner"})
    EXPECT_EQ(measured_again(own), each) << own;
  for (const char* other : {"own/bdf", "own/yoshida", "case/kepler"})
    EXPECT_EQ(measured_again(other), 0U) << other;
  if (units_.contains("adapter/gsl")) {
    EXPECT_EQ(measured_again("adapter/gsl"), 0U);
  }
}

TEST_F(Kept, AnEditOfTheCaseTheJudgeOrTheRunnerMeasuresAllAgain) {
  // The judge measures amplifications by methods of the last two.
  for (const char* unit : {"case/free_fall", "rest", "own/dormand", "own/radau"})
    EXPECT_EQ(measured_again(unit), results_) << unit;
}

}  // namespace
}  // namespace odeum::tests
