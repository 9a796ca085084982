// SPDX-License-Identifier: BSD-3-Clause
// Archives of results: what is read from one is what was put into it; what is not one is refused.
#include "odeum/record/archive.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "odeum/compare/folders.hpp"
#include "odeum/compare/overlay.hpp"
#include "odeum/record/compress.hpp"
#include "odeum/record/output_folder.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::archive_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* manifest = R"({"odeum": {"version": "1"}, "options": {}, "cpu": "one"})";
constexpr const char* header =
    "schema,case,library,solver,status,setting_kind,setting,error,wall_ns_min,rhs_evaluations\n";
/// Two solvers on a case, each at two settings.
constexpr const char* older =
    "1,a,gsl,rk4,ok,step,0.1,1e-3,100,40\n1,a,gsl,rk4,ok,step,0.05,1e-5,200,80\n"
    "1,a,cvode,bdf,ok,tol,1e-4,5e-4,400,30\n1,a,cvode,bdf,ok,tol,1e-7,9e-6,800,90\n";
/// One of them on a machine of half the speed, and a new solver.
constexpr const char* newer =
    "1,a,gsl,rk4,ok,step,0.1,1e-3,200,40\n1,a,gsl,rk4,ok,step,0.05,1e-5,400,80\n"
    "1,a,mine,fast,ok,tol,1e-4,9e-4,100,20\n1,a,mine,fast,ok,tol,1e-6,8e-6,300,60\n"
    "1,a,mine,fast,over_budget,tol,1e-9,nan,nan,90\n";

class Archives : public testing::Test {
 protected:
  void SetUp() override {
    write("old/manifest.json", manifest);
    write("old/precision.csv", std::string(header) + older);
    write("old/page.json", "{}");
    write("new/manifest.json", R"({"odeum": {"version": "1"}, "options": {}, "cpu": "two"})");
    write("new/precision.csv", std::string(header) + newer);
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(path(name).parent_path());
    write_text(path(name), text);
  }
  std::string packed() const { return record::gzip_of(record::archive_of(path("old"))); }
  /// Why the bytes are refused; empty: they are not.
  std::string fault_of(const std::string& bytes) const {
    write("damaged.tar.gz", bytes);
    try {
      record::read_archive(path("damaged.tar.gz"));
    } catch (const record::ArchiveError& error) {
      return error.what();
    }
    return "";
  }

  const TemporaryFolder folder_;
};

TEST_F(Archives, HoldTheManifestAndTheTables) {
  write("old/region.csv.gz", record::gzip_of("schema,x\n1,2\n"));
  write("old/results.tar.gz", "an earlier one");
  write("whole.tar.gz", packed());
  const record::Archive archive = record::read_archive(path("whole.tar.gz"));
  ASSERT_EQ(archive.size(), 3U);
  EXPECT_EQ(archive.at("manifest.json"), manifest);
  EXPECT_EQ(archive.at("precision.csv"), std::string(header) + older);
  EXPECT_EQ(archive.at("region.csv"), "schema,x\n1,2\n");
  // A folder and its archive are the same results.
  const compare::Differences found =
      compare::compare_folders(path("whole.tar.gz"), path("old"), {});
  EXPECT_TRUE(found.rows.empty());
  EXPECT_EQ(found.tables, 2U);
  EXPECT_EQ(found.compared, 5U);
}

TEST_F(Archives, ThatAreCutOrHaveABitFlippedAreRefused) {
  const std::string whole = packed();
  write("whole.tar.gz", whole);
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_NE(fault_of(whole.substr(0, size)), "") << size;
  EXPECT_NE(fault_of(whole + "more"), "");
  // The ten bytes of gzip's header have a date and a system that are not checked.
  for (std::size_t at = 10; at < whole.size(); ++at) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (at % 8)));
    // Some bits mean nothing, as those between two blocks.
    if (fault_of(flipped).empty()) {
      EXPECT_EQ(record::read_archive(path("damaged.tar.gz")),
                record::read_archive(path("whole.tar.gz")))
          << at;
    }
  }
}

TEST_F(Archives, OfWhatNoFolderHasAreRefused) {
  const std::string tar = record::archive_of(path("old"));
  const auto with_name = [&](const std::string& name, char kind) {
    std::string changed = tar;
    const std::size_t at = changed.find("precision.csv");
    changed.replace(at, std::max<std::size_t>(name.size(), 13),
                    name + std::string(13 - std::min<std::size_t>(13, name.size()), '\0'));
    changed[at + 156] = kind;
    changed.replace(at + 148, 8, "        ");
    unsigned sum = 0;
    for (std::size_t k = 0; k < 512; ++k) sum += static_cast<unsigned char>(changed[at + k]);
    changed.replace(at + 148, 7, fmt::format("{:06o}", sum) + '\0');
    return record::gzip_of(changed);
  };
  EXPECT_EQ(fault_of(with_name("other.csv", '0')), "");
  for (const char* name : {"../x.csv", "/x.csv", "a/b.csv", "x.so", "manifest.json", ""})
    EXPECT_NE(fault_of(with_name(name, '0')), "") << name;
  for (const char kind : {'1', '2', '5', 'L', 'x', '\0'})
    EXPECT_NE(fault_of(with_name("other.csv", kind)), "") << kind;
  EXPECT_NE(fault_of(record::gzip_of("")), "");
  EXPECT_NE(fault_of(record::gzip_of(std::string(1024, '\0'))).find("has no manifest.json"),
            std::string::npos);
  EXPECT_NE(fault_of(record::gzip_of(tar + std::string(512, 'x'))), "");
}

TEST_F(Archives, AreLaidOverBySolversOfAnotherMachine) {
  write("old.tar.gz", packed());
  const compare::ResultSet before(path("old.tar.gz")), after(path("new"));
  const compare::Overlay overlay = compare::overlay_of(before, after);
  // At 1e-3 the new one needs 20 evaluations and the best older one 30, at 1e-5 60 and 80.
  ASSERT_EQ(overlay.rows.size(), 4U);
  const compare::OverlayRow &coarse = overlay.rows[1], &fine = overlay.rows[3];
  EXPECT_EQ(coarse.error, 1e-3);
  EXPECT_EQ(coarse.solver, "fast");
  EXPECT_EQ(coarse.evaluations, 20);
  EXPECT_EQ(coarse.best, "cvode/bdf");
  EXPECT_EQ(coarse.best_evaluations, 30);
  EXPECT_EQ(coarse.place, 1);
  EXPECT_EQ(coarse.of, 2);
  EXPECT_EQ(fine.error, 1e-5);
  EXPECT_EQ(fine.best, "gsl/rk4");
  EXPECT_EQ(fine.ratio, 0.75);
  // Two runs are in both, which is too few for a hint.
  EXPECT_TRUE(std::isnan(fine.time_hint));
  EXPECT_NE(overlay.speed.find("2 runs are in both"), std::string::npos) << overlay.speed;
  const compare::Differences common = compare::compare_common(before, after, {}, 0);
  EXPECT_TRUE(common.rows.empty()) << "accuracy of what both have is the same";
}

TEST_F(Archives, GiveAHintOfSpeedByRunsThatBothHave) {
  const std::string third = "1,a,gsl,rk4,ok,step,0.025,1e-7,";
  write("old/precision.csv", header + (older + third) + "400,160\n");
  write("new/precision.csv", header + (newer + third) + "800,161\n");
  const compare::ResultSet before(path("old")), after(path("new"));
  const compare::Overlay overlay = compare::overlay_of(before, after);
  // 300 ns there are 150 here, and the fastest older one takes 200.
  EXPECT_EQ(overlay.rows.at(3).time_hint, 0.75);
  EXPECT_NE(overlay.speed.find("a hint: the first was measured on one, the second on two"),
            std::string::npos)
      << overlay.speed;
  const compare::Differences common = compare::compare_common(before, after, {}, 0);
  ASSERT_EQ(common.rows.size(), 1U);
  EXPECT_EQ(common.rows[0].quantity, "rhs_evaluations");
  EXPECT_TRUE(common.has_regression());
}

TEST_F(Archives, OfAnotherFormatAreRefused) {
  write("old.tar.gz", packed());
  std::string other = std::string(header) + newer;
  for (std::size_t at = 0; (at = other.find("\n1,", at)) != std::string::npos; ++at)
    other[at + 1] = '2';
  write("new/precision.csv", other);
  const compare::ResultSet before(path("old.tar.gz")), after(path("new"));
  try {
    compare::compare_common(before, after, {}, 0);
    FAIL() << "tables of two formats were compared";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("has version 1 in the first and 2 in the second"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace odeum::tests::archive_test
