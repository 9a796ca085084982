// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "odeum/report/shared_files.hpp"
#include "odeum/report/text.hpp"

namespace odeum::report::report_text_test {
namespace {

const std::string unknown = "\xEF\xBF\xBD";  // U+FFFD

TEST(SafeText, OneLineWithoutControls) {
  EXPECT_EQ(plain("a\nb\tc\r"), "a b c ");
  EXPECT_EQ(plain("\x1b[31mred"), unknown + "[31mred");
  EXPECT_EQ(plain(std::string("\x01", 1) + "7\x02"), unknown + "7" + unknown);
  EXPECT_EQ(plain("\xC2\x9B"
                  "31m"),
            unknown + "31m")
      << "the one-character form of ESC [";
  EXPECT_EQ(plain("a\xE2\x80\xAEz"), "a" + unknown + "z") << "right-to-left override";
  EXPECT_EQ(plain(std::string_view("a\0b", 3)), "a" + unknown + "b");
}

TEST(SafeText, KeepsUtf8AndReplacesWhatIsNone) {
  EXPECT_EQ(plain("ζ ≤ 𝜋"), "ζ ≤ 𝜋");
  EXPECT_EQ(plain("\xff"
                  "a"),
            unknown + "a");
  EXPECT_EQ(plain("\xC0\xAF"), unknown + unknown) << "an overlong slash";
  EXPECT_EQ(plain("\xED\xA0\x80"), unknown + unknown + unknown) << "a surrogate";
  EXPECT_EQ(plain("\xE2\x82"), unknown + unknown) << "cut off";
}

TEST(SafeText, Base64AsInRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(SafeText, FileStems) {
  EXPECT_EQ(file_stem("odeum/rk4-a_B"), "odeum_rk4-a_B");
  EXPECT_EQ(file_stem("../<a>\x1b"), "____a__");
  EXPECT_EQ(file_stem(""), "_");
  EXPECT_EQ(file_stem(std::string(1000, 'a')).size(), 80U);
}

TEST(SharedFiles, LieBesideTheProgram) {
  EXPECT_NE(shared_text("viewer/page.css").find("prefers-color-scheme: dark"), std::string::npos);
  EXPECT_NE(shared_text("documents/findings.md").find("# Findings"), std::string::npos);
  EXPECT_EQ(shared_text("viewer/none"), "");
}

TEST(SharedFiles, ATemplateIsFilledIn) {
  const std::string page = filled_template("viewer/replay/replay.html", "{\"a\":\"{{data}}\"}");
  EXPECT_NE(page.find("{\"a\":\"{{data}}\"}"), std::string::npos) << "data are not a template";
  EXPECT_EQ(page.find("{{include"), std::string::npos);
}

}  // namespace
}  // namespace odeum::report::report_text_test
