// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/csv.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <random>

namespace odeum::tests::csv_test {
namespace {

using record::format_number;
using record::format_text;

TEST(Csv, WritesNumbersThatReadBackToTheSameDouble) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t bits = random();
    const auto value = std::bit_cast<double>(bits);
    if (!std::isfinite(value)) continue;
    const std::string text = format_number(value);
    double back = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), back);
    ASSERT_EQ(error, std::errc{});
    ASSERT_EQ(end, text.data() + text.size());
    ASSERT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

TEST(Csv, WritesTheShortestTextAndNamesWhatIsNoNumber) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(0), "0");
  EXPECT_EQ(format_number(1e-300), "1e-300");
  EXPECT_EQ(format_number(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(format_number(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(format_number(std::numeric_limits<double>::denorm_min()), "5e-324");
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Csv, DoesNotDependOnTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})  // where one is installed
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  EXPECT_EQ(format_number(1234567.25), "1234567.25");
  EXPECT_EQ((record::Records{{"x", "n"}, {{0.5, 1234567}}}.csv()), "schema,x,n\n1,0.5,1234567\n");
  std::setlocale(LC_ALL, c_before.c_str());
  std::locale::global(before);
}

TEST(Csv, QuotesWhatNeedsIt) {
  EXPECT_EQ(format_text("plain text"), "plain text");
  EXPECT_EQ(format_text(""), "");
  EXPECT_EQ(format_text("a,b"), "\"a,b\"");
  EXPECT_EQ(format_text("say \"no\""), "\"say \"\"no\"\"\"");
}

TEST(Csv, DisarmsFormulas) {
  for (const std::string start : {"=", "+", "-", "@"})
    EXPECT_EQ(format_text(start + "1+1"), "'" + start + "1+1");
  EXPECT_EQ(format_text("=1,\"2\""), "\"'=1,\"\"2\"\"\"");
  EXPECT_EQ(format_text("a=1"), "a=1");
}

TEST(Csv, LetsNoControlCharacterThrough) {
  EXPECT_EQ(format_text("two\r\nlines\tand \x1b[31mred\x7f"), "two  lines and  [31mred ");
  EXPECT_EQ(format_text(std::string("nul\0!", 5)), "nul !");
  // U+009B starts a terminal escape as ESC [ does; in UTF-8 it is two bytes.
  EXPECT_EQ(format_text("\xc2\x9b"
                        "31m"),
            " 31m");
  EXPECT_EQ(format_text("\xc2\xa0\xc3\x9b\xc2"), "\xc2\xa0\xc3\x9b\xc2") << "other text is kept";
  EXPECT_EQ(format_text("h\xc3\xa4nging \xe2\x88\x9e"), "h\xc3\xa4nging \xe2\x88\x9e");
}

TEST(Csv, RecordsHaveOneLineARow) {
  const record::Records table{
      {"case", "error", "steps"},
      {{"x,y", -0.25, std::uint64_t{18446744073709551615U}}, {"=z", std::nan(""), 0}}};
  EXPECT_EQ(table.csv(),
            "schema,case,error,steps\n1,\"x,y\",-0.25,18446744073709551615\n1,'=z,nan,0\n");
  ASSERT_EQ(table.fields().size(), 2U);
  EXPECT_EQ(table.fields()[1][0].column, "case");
  EXPECT_EQ(std::get<std::string>(table.fields()[1][0].value), "=z") << "as it was given";
}

}  // namespace
}  // namespace odeum::tests::csv_test
