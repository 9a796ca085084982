// SPDX-License-Identifier: BSD-3-Clause
// Names and cells from outside: a terminal shows them and obeys none, a spreadsheet computes none,
// and a shell runs none.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "odeum/input/utf8.hpp"
#include "odeum/record/csv.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::outside_text_test {
namespace {

using tests::Result;
using tests::shell;

TEST(OutsideText, IsEscapedForATerminal) {
  EXPECT_EQ(for_terminal("plain, \ttabs\nand lines: x² ≤ 1 μs"),
            "plain, \ttabs\nand lines: x² ≤ 1 μs");
  EXPECT_EQ(for_terminal("a\x1b]0;title\x07z"), "a\\u001b]0;title\\u0007z");
  EXPECT_EQ(for_terminal("over\rwritten\x7f\x08"), "over\\u000dwritten\\u007f\\u0008");
  EXPECT_EQ(for_terminal("\u202Etxt.exe\u2066\u200B"), "\\u202etxt.exe\\u2066\\u200b");
  EXPECT_EQ(for_terminal("\u009b31m"), "\\u009b31m") << "an escape in one character";
  EXPECT_EQ(for_terminal("\xff\x9b"), "\uFFFD\uFFFD");
  EXPECT_EQ(for_terminal(std::string("\0", 1)), "\\u0000");
  const std::string strange = "\u202E\u009b\U000E0041\u2028 end";
  const std::string json = nlohmann::json(strange).dump();
  EXPECT_NE(for_terminal(json), json);
  EXPECT_EQ(nlohmann::json::parse(for_terminal(json)), strange) << "JSON stays the same data";
}

TEST(OutsideText, BeginsNoFormulaInAHeader) {
  const std::string formula = R"(=HYPERLINK("http://x","y"))";
  EXPECT_EQ(record::csv_header({{formula, 1.0}, {"@b", 1.0}}),
            "schema,\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\",'@b\n");
  EXPECT_EQ(record::Records{{formula}}.csv(),
            "schema,\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"\n");
}

class OutsideWords : public testing::Test {
 protected:
  OutsideWords() { std::filesystem::create_directories(folder_.path()); }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_.path() / file) << text;
  }
  Result run(const std::string& command) const {
    return shell("cd '" + folder_.path().string() + "' && " + command);
  }
  static void expect_harmless(const Result& result) {
    for (const char* bad : {"\x1b", "\r", "\u202E", "\u009b", "\x07"})
      EXPECT_EQ(result.output.find(bad), std::string::npos) << result.output;
  }
  tests::TemporaryFolder folder_;
};

// A title in an answer, a header that is not understood, a file's own name, and a column of a
// plan's file.
TEST_F(OutsideWords, NeverReachATerminalAsTheyAre) {
  const std::string name = "\\e[31mred\\r\\u202Ecod\\u009b2J\\a";  // of YAML
  write("strange.yaml", "name: \"" + name +
                            "\"\nparameters: {k: 1}\nstates: {x: 1}\nequations: {x: -k*x}\n"
                            "time: {end: 1}\n");
  write("members.csv", "k\x1b[31m\r,\u202Ex\n1,2\n");
  const std::string bad = "$'\\e[31m\\r\u202E'";
  for (const std::string& command :
       {std::string("odeum run strange.yaml --solver rk4 --step 0.1 --no-truth"),
        std::string("odeum converge strange.yaml --solver rk4 --quick --out out"),
        std::string("odeum list solvers strange.yaml --format csv"),
        std::string("odeum sweep strange.yaml --over-file members.csv --solver rk4 --step 0.1"),
        "odeum run " + bad, "odeum converge --solver " + bad, "odeum status " + bad,
        "odeum run lotka_volterra --solver " + bad + " --step 1", "odeum " + bad,
        "odeum list --" + bad})
    expect_harmless(run(command));
}

// The folder's name is a command, and has the letter that `xargs -I K` replaced.
TEST_F(OutsideWords, StandInCommandsAsOneWord) {
  write("decay.yaml", "parameters: {k: 1}\nstates: {x: 1}\nequations: {x: -k*x}\ntime: {end: 1}\n");
  const Result plan = run(
      "odeum plan sweep decay.yaml --over k=1..2:4 --solver rk4 --step 0.1 --check 0 --shards 2 "
      "--out \"Kepler'; touch PWNF; '\"");
  ASSERT_EQ(plan.code, 0) << plan.output;
  const std::size_t begin = plan.output.find("here    ") + 8;
  const std::string here = plan.output.substr(begin, plan.output.find('\n', begin) - begin);
  const std::size_t program = here.find("odeum");
  const Result shards = run(std::string(here).replace(program, 5, "'" ODEUM_BINARY "'"));
  EXPECT_EQ(shards.code, 0) << here << "\n" << shards.output;
  EXPECT_EQ(run("odeum merge \"Kepler'; touch PWNF; '\" --out merged").code, 0);
  const Result film =
      run("odeum run spring_midpoint --until 0.05 --out \"x'; touch PWNF; '\" --film 2");
  const std::size_t ffmpeg = film.output.find("ffmpeg ");
  if (ffmpeg != std::string::npos)
    run("ffmpeg() { :; }; " + film.output.substr(ffmpeg, film.output.find('\n', ffmpeg) - ffmpeg));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "PWNF"));
}

}  // namespace
}  // namespace odeum::outside_text_test
