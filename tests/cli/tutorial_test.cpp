// SPDX-License-Identifier: BSD-3-Clause
// The commands of reports/docs/tutorial.md print the lines that stand below them.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::tutorial_test {
namespace {

/// The texts between the fences.
std::vector<std::string> blocks_of(const std::string& document) {
  static const std::regex block("\n```[a-z]*\n([^`]*)```");
  std::vector<std::string> blocks;
  for (std::sregex_iterator each(document.begin(), document.end(), block), end; each != end; ++each)
    blocks.push_back((*each)[1]);
  return blocks;
}

/// Without its numbers and the width of its columns, which follow from them.
std::string words_of(const std::string& line) {
  static const std::regex number("[-+]?(?:[0-9]+(?:\\.[0-9]+)?(?:e[-+]?[0-9]+)?|inf)\\b"),
      spaces(" +");
  return std::regex_replace(std::regex_replace(line, number, "#"), spaces, " ");
}

bool has_line(const std::string& output, const std::string& expected) {
  const std::string words = words_of(expected.substr(0, expected.find("...")));
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (words_of(line).starts_with(words)) return true;
  return false;
}

TEST(Tutorial, CommandsPrintWhatItShows) {
  const std::vector<std::string> blocks =
      blocks_of(text_of(ODEUM_SOURCE_DIR "/reports/docs/tutorial.md"));
  const std::string start = "scripts/odeum ";
  const TemporaryFolder folder;
  std::size_t shown = 0;
  for (std::size_t k = 0; k + 1 < blocks.size(); ++k) {
    if (blocks[k].starts_with("name: "))
      std::ofstream(folder.path() / "pendulum.yaml") << blocks[k];
    // The fastest solvers and what a whole report says depend on the machine.
    if (!blocks[k].starts_with(start) || blocks[k].find(" precision ") != std::string::npos ||
        blocks[k].find(" report ") != std::string::npos)
      continue;
    const std::string command =
        "odeum " + blocks[k].substr(start.size(), blocks[k].find('\n') - start.size());
    const Result result = shell("cd " + folder.path().string() + " && " + command);
    EXPECT_EQ(result.code, 0) << command << '\n' << result.output;
    std::istringstream lines(blocks[k + 1].starts_with(start) ? "" : blocks[k + 1]);
    for (std::string line; std::getline(lines, line); ++shown)
      EXPECT_TRUE(has_line(result.output, line)) << command << " does not print\n"
                                                 << line << "\nbut\n"
                                                 << result.output;
  }
  EXPECT_GE(shown, 20U) << "the tutorial was not read";
}

}  // namespace
}  // namespace odeum::tests::tutorial_test
