// SPDX-License-Identifier: BSD-3-Clause
// The commands and options that documents name are those of the program.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::document_commands_test {
namespace {

namespace fs = std::filesystem;

/// The help of a command; empty where there is no such command.
const std::string& help_of(const std::string& command) {
  static std::map<std::string, std::string> known;
  const auto [at, is_new] = known.try_emplace(command);
  if (is_new)
    if (const Result result = shell("odeum " + command + " --help"); result.code == 0)
      at->second = result.output;
  return at->second;
}

std::set<std::string> options_in(const std::string& text) {
  static const std::regex option("(?:^|[\\s,\\[`'(])(--[a-z][a-z-]*)");
  std::set<std::string> found;
  for (std::sregex_iterator each(text.begin(), text.end(), option), end; each != end; ++each)
    found.insert((*each)[1]);
  return found;
}

void expect_known(const fs::path& document, const std::string& command, const std::string& words) {
  const std::string& help = help_of(command);
  if (help.empty()) {
    ADD_FAILURE() << document << ": no command " << command << " in: odeum " << command << words;
    return;
  }
  std::set<std::string> known = options_in(help);
  // A plan takes the options of the command that it cuts.
  static const std::regex next("^ ([a-z]+)");
  std::smatch sub;
  if (command == "plan" && std::regex_search(words, sub, next))
    known.merge(options_in(help_of(sub[1])));
  for (const std::string& option : options_in(words))
    EXPECT_TRUE(known.contains(option))
        << document << ": odeum " << command << " has no " << option;
}

TEST(DocumentCommands, AndTheirOptionsExist) {
  // At the begin of a line or of a code span; the words end at what a shell would end them.
  static const std::regex command("(?:^|\\n|`|\\$ |&& )(?:scripts/)?odeum ([a-z]+)([^\\n`|#&;]*)");
  const fs::path root = ODEUM_SOURCE_DIR;
  std::size_t commands = 0;
  for (const char* folder :
       {".", "reports", "reports/docs", "reports/findings", "cases/problems", "cases/scenes"})
    for (const fs::directory_entry& entry : fs::directory_iterator(root / folder)) {
      if (entry.path().extension() != ".md" || entry.path().filename() == "reference.md") continue;
      const std::string text = text_of(entry.path());
      for (std::sregex_iterator each(text.begin(), text.end(), command), end; each != end; ++each) {
        expect_known(entry.path().filename(), (*each)[1], (*each)[2]);
        ++commands;
      }
    }
  EXPECT_GE(commands, 100U) << "the documents were not read";
}

TEST(DocumentCommands, HelpEndsWithTwoThatExist) {
  std::istringstream all(shell("odeum help").output);
  std::size_t commands = 0;
  bool listed = false;
  for (std::string line; std::getline(all, line);) {
    listed = listed || line == "Questions:";
    if (!listed || !line.starts_with("  ") || line[2] == ' ') continue;
    const std::string name = line.substr(2, line.find(' ', 2) - 2), &help = help_of(name);
    if (name == "help") continue;  // that of all
    const std::size_t at = help.find("\nExamples:\n");
    ASSERT_NE(at, std::string::npos) << name;
    static const std::regex example("\n  (?:seq [^\n]*)?odeum ([a-z]+)([^\n]*)");
    const std::string text = help.substr(at + 10);
    std::size_t examples = 0;
    for (std::sregex_iterator each(text.begin(), text.end(), example), end; each != end; ++each) {
      expect_known(name, (*each)[1], (*each)[2]);
      ++examples;
    }
    EXPECT_EQ(examples, 2U) << help;
    ++commands;
  }
  EXPECT_GE(commands, 30U);
}

}  // namespace
}  // namespace odeum::tests::document_commands_test
