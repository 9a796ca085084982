// SPDX-License-Identifier: BSD-3-Clause
// Tables as spreadsheets and other programs write them.
#include "odeum/input/csv_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace odeum::csv_text_test {
namespace {

std::string shown(std::string_view line, char separator) {
  std::string text;
  for (const input::Cell& cell : input::cells_of(line, separator))
    text += std::to_string(cell.column) + ":" + std::string(cell.text) + "|";
  return text;
}

TEST(CsvText, CellsBeginAtTheirColumnsWithoutBlanksAndQuotes) {
  EXPECT_EQ(shown(R"(t, "x, in m" ,,3)", ','), "1:t|4:x, in m|15:|16:3|");
  EXPECT_EQ(shown("  1\t 2   3 ", ' '), "3:1|6:2|10:3|");
}

TEST(CsvText, DecimalCommasStandBesideSemicolonsAndTabs) {
  EXPECT_EQ(input::separator_of("0,5;1,5"), ';');
  EXPECT_EQ(input::separator_of("0,5\t1,5"), '\t');
  EXPECT_EQ(input::separator_of("0.5,1.5"), ',');
  EXPECT_EQ(input::separator_of("0.5 1.5"), ' ');
}

TEST(CsvText, NumbersAreWholeCells) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(input::number_in("+0.5"), 0.5);
  EXPECT_EQ(input::number_in("0,5", true), 0.5);
  EXPECT_EQ(input::number_in("1e400"), infinity);
  EXPECT_EQ(input::number_in("-1e400"), -infinity);
  EXPECT_EQ(input::number_in("1e-400"), 0);
  for (const char* const text : {"", "x", "0.5x", "0,5", "0.5 m", "++1"})
    EXPECT_FALSE(input::number_in(text)) << text;
}

TEST(CsvText, LinesKeepTheirNumbersAndLoseMarksAndBlankLines) {
  std::string found;
  for (input::Lines lines("\xEF\xBB\xBFk,m\r\n\r\n1,2\n\n3,4"); lines.next();)
    found += std::to_string(lines.number()) + "=" + std::string(lines.line()) + ";";
  EXPECT_EQ(found, "1=k,m;3=1,2;5=3,4;");
}

}  // namespace
}  // namespace odeum::csv_text_test
