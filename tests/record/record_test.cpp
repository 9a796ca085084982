// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "odeum/record/rows.hpp"
#include "odeum/record/table.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::record::record_test {
namespace {

using tests::TemporaryFolder;
using tests::text_of;

enum class Colour { red, green };
const char* to_string(Colour colour) { return colour == Colour::red ? "red" : "green"; }

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A row with a member of every kind.
struct AnyRow {
  std::string case_id, library = "odeum", solver;
  double number = 0;
  std::size_t count = 0;
  int offset = 0;
  bool flag = false, chosen = false;
  std::complex<double> z{};
  Colour colour = Colour::red;
  std::optional<int> order = {};
  std::vector<float> kept = {};

  static constexpr const char* file = "any.csv";
  ODEUM_COLUMNS(case_id, library, solver, number, count, offset, flag,
                column("chosen", PhraseColumn{chosen, "no", "yes"}), z, colour, order,
                column("kept", StoredOnly{kept}), column("twice", ComputedColumn{2 * number}))
};

struct OtherRow {
  std::string case_id, library, solver;
  double value = 0;
  static constexpr const char* file = "other.csv";
  static constexpr bool keeps_earlier = true;
  static constexpr bool compared_within_case = true;
  ODEUM_COLUMNS(case_id, library, solver, value)
};

struct AnyResult {
  std::vector<AnyRow> any;
  std::vector<OtherRow> other;
  static auto lists(auto& result) { return std::tie(result.any, result.other); }
};

AnyResult some_rows() {
  AnyRow first{.case_id = "a", .solver = "rk4, \"quoted\"", .number = 0.1, .count = 7};
  first.offset = -3, first.flag = first.chosen = true;
  first.z = {1e-300, -2}, first.colour = Colour::green, first.order = 4;
  first.kept = {1.5F, std::numeric_limits<float>::infinity(), 0.1F};
  AnyRow second{.case_id = "b", .solver = "heun", .number = nan};
  return {{first, second}, {{"a", "odeum", "rk4", 1}, {"a", "odeum", "heun", 2}}};
}

TEST(Rows, AFileHasTheColumnsOfItsRowsAndReadsBackToTheSame) {
  const TemporaryFolder root;
  const OutputFolder folder(root.path() / "out"), again(root.path() / "again");
  const AnyResult written = some_rows();
  write(written, folder);
  EXPECT_EQ(
      text_of(folder.path() / "any.csv"),
      "schema,case,library,solver,number,count,offset,flag,chosen,z_re,z_im,colour,order,twice"
      "\n1,a,odeum,\"rk4, \"\"quoted\"\"\",0.1,7,-3,1,yes,1e-300,-2,green,4,0.2\n"
      "1,b,odeum,heun,nan,0,0,0,no,0,0,red,nan,nan\n");
  std::string problem;
  const auto read_back = read<AnyResult>(folder.path(), problem);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(read_back.any.size(), 2U);
  EXPECT_EQ(read_back.any[0].z, written.any[0].z);
  EXPECT_EQ(read_back.any[0].order, 4);
  EXPECT_EQ(read_back.any[1].order, std::nullopt);
  EXPECT_TRUE(read_back.any[0].kept.empty()) << "no column";
  write(read_back, again);
  for (const auto& [file, columns] : files_of<AnyResult>())
    EXPECT_EQ(text_of(folder.path() / file), text_of(again.path() / file)) << file;
}

// A result of an earlier run is read and written again by each report.
TEST(Rows, ATextThatASpreadsheetWouldRunStaysTheSameThroughManyRounds) {
  const TemporaryFolder root;
  const OutputFolder folder(root.path() / "out");
  const std::vector<std::string> texts{"=1+1", "-x, \"y\"", "@", "'=x", "''-x", "'quoted'", "'"};
  std::vector<OtherRow> rows;
  for (const std::string& text : texts) rows.push_back({text, "odeum", "rk4", -1});
  write_rows(rows, folder);
  const std::string first = text_of(folder.path() / "other.csv");
  EXPECT_NE(first.find("'=1+1,"), std::string::npos) << "disarmed";
  std::string problem;
  for (int round = 0; round < 2; ++round)
    write_rows(read_rows<OtherRow>(folder.path(), problem), folder);
  EXPECT_EQ(text_of(folder.path() / "other.csv"), first);
  const std::vector<OtherRow> back = read_rows<OtherRow>(folder.path(), problem);
  ASSERT_EQ(back.size(), texts.size()) << problem;
  for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(back[i].case_id, texts[i]);
}

TEST(Rows, ARecordOfTheJournalKeepsEverythingExactly) {
  AnyResult written = some_rows();
  written.any[1].solver = "line\nbreak, \ttab and 'quote";
  const std::string record = to_record(written);
  const auto read_back = from_record<AnyResult>(record);
  EXPECT_EQ(to_record(read_back), record);
  ASSERT_EQ(read_back.any.size(), 2U);
  EXPECT_EQ(read_back.any[0].kept, written.any[0].kept);
  EXPECT_EQ(read_back.any[1].solver, written.any[1].solver);
  EXPECT_EQ(read_back.other.size(), 2U);
  for (std::size_t length = 0; length < record.size(); ++length)
    EXPECT_THROW(from_record<AnyResult>(record.substr(0, length)), BadField) << length;
}

TEST(Rows, MissingFilesAreNoProblemAndBrokenOnesAreNotUsed) {
  const TemporaryFolder root;
  const OutputFolder folder(root.path() / "out");
  std::string problem;
  const auto missing = read<AnyResult>(folder.path(), problem);
  EXPECT_TRUE(missing.any.empty() && missing.other.empty());
  EXPECT_EQ(problem, "");
  write(some_rows(), folder);
  const std::string whole = text_of(folder.path() / "any.csv");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  const auto problem_of = [&](const std::string& text) {
    folder.write("any.csv", text);
    std::string why;
    const auto read_back = read<AnyResult>(folder.path(), why);
    EXPECT_TRUE(read_back.any.empty());
    EXPECT_FALSE(read_back.other.empty()) << "the other file is as good as before";
    return why;
  };
  EXPECT_EQ(problem_of(whole.substr(0, whole.size() - 7)), "the earlier any.csv is truncated");
  for (const std::string& text : {std::string(), std::string("schema,case\n1,a\n"), "x" + whole})
    EXPECT_EQ(problem_of(text), "the earlier any.csv has other columns (another version?)");
  for (const std::string& text :
       {with(",0.1,", ",slow,"), with(",green,", ",blue,"), with(",yes,", ",maybe,"),
        with(",7,", ",-7,"), with("\n1,", "\n2,")})
    EXPECT_EQ(problem_of(text),
              "the earlier any.csv has a field that is not a number, or another schema");
}

TEST(Rows, WhatIsMeasuredNowReplacesWhatWas) {
  AnyResult now;
  now.any = {{.case_id = "a", .solver = "rk4", .number = 1}};
  AnyResult earlier;
  for (const char* id : {"a", "b", "gone"})
    for (const char* solver : {"rk4", "heun"}) {
      earlier.any.push_back({.case_id = id, .solver = solver, .number = 2});
      earlier.other.push_back({id, "odeum", solver, 2});
    }
  now.other = {{"a", "odeum", "rk4", 1}};
  add_earlier(now, earlier, [](const std::string& case_id, const std::string& solver) {
    return case_id != "gone" && solver != "odeum/unknown";
  });
  ASSERT_EQ(now.any.size(), 4U) << "each pair once, and not the case that went";
  EXPECT_EQ(now.any[0].number, 1);
  EXPECT_EQ(now.any[1].solver, "heun") << "of case a";
  ASSERT_EQ(now.other.size(), 3U) << "rows of a case stay together";
  EXPECT_EQ(now.other[1].case_id, "b");
}

TEST(Rows, AnEmptyListMayKeepAnEarlierFile) {
  const TemporaryFolder root;
  const OutputFolder folder(root.path() / "out");
  write(some_rows(), folder);
  const std::string before = text_of(folder.path() / "other.csv");
  write(AnyResult(), folder);
  EXPECT_EQ(text_of(folder.path() / "other.csv"), before);
  EXPECT_EQ(text_of(folder.path() / "any.csv").find("\n1,"), std::string::npos);
}

TEST(Table, ChoosesColumnsByNameAndAlignsNumbers) {
  EXPECT_EQ(table_of(some_rows().other, "case solver value:.1f").text(),
            "case  solver      value\n"
            "a     odeum/rk4     1.0\n"
            "a     odeum/heun    2.0\n");
  EXPECT_THROW(table_of(some_rows().other, "no_such_column"), std::out_of_range);
}

TEST(Table, ShowsADashForWhatIsNotKnown) {
  std::vector<AnyRow> rows(2);
  rows[0].number = nan;
  rows[0].z = {nan, nan};
  rows[1].z = {1, 2};
  EXPECT_EQ(table_of(rows, "number:.1f z count").rows,
            (std::vector<std::vector<std::string>>{{"-", "-", "0"}, {"0.0", "1 +2i", "0"}}));
}

struct ShownRow {
  std::string status, detail;
  static constexpr const char* file = "shown.csv";
  static constexpr const char* shown = "status";
  ODEUM_COLUMNS(status, detail)
};
struct ShownResult {
  std::vector<ShownRow> first, second;
  std::vector<OtherRow> hidden;
  static auto lists(auto& result) { return std::tie(result.first, result.second, result.hidden); }
};

TEST(Table, AResultShowsTheListsThatSaySoAndHaveRows) {
  ShownResult result{{{"ok", ""}, {"failed", "why"}}, {}, {{"a", "odeum", "rk4", 1}}};
  EXPECT_EQ(tables_of(result), "status\nok\nfailed: why\n");
  result.second = {{"late", ""}};
  EXPECT_EQ(tables_of(result),
            "shown.csv\n\nstatus\nok\nfailed: why\n\nshown.csv\n\nstatus\nlate\n");
}

}  // namespace
}  // namespace odeum::record::record_test
