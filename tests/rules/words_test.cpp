// SPDX-License-Identifier: BSD-3-Clause
// Comments, messages and documents are plain sentences: CONTRIBUTING.md, "Words".
#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/temporary_folder.hpp"

namespace odeum::rules::words_test {
namespace {

namespace fs = std::filesystem;

const fs::path root = ODEUM_SOURCE_DIR;

/// A line that breaks a rule, from 1, and the words that do.
struct Fault {
  std::size_t line;
  std::string words;
  bool operator==(const Fault&) const = default;
};

/// Comments that begin with a genitive or a relative clause, and so have no noun and no verb. A
/// paragraph of a comment begins a comment too; `mark` is // or #.
std::vector<Fault> headless_comments(const std::string& text, const std::string& mark) {
  const std::regex comment("^\\s*" + mark + "[/!]?<?(.*)"),
      trailing("\\s" + mark + "[/!]?<?\\s+(Of|By|Those|That)\\b.*"),
      headless("\\s+(Of|By|Those|That)\\b.*");
  std::vector<Fault> faults;
  std::istringstream lines(text);
  std::size_t number = 0;
  bool begins = true;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch match;
    const bool marked = line.find(mark) != std::string::npos,
               whole = marked && std::regex_match(line, match, comment);
    const std::string words = whole ? match[1].str() : "";
    if (whole ? begins && std::regex_match(words, headless)
              : marked && std::regex_search(line, trailing))
      faults.push_back({number, line});
    // The line of the licence is a comment of its own.
    begins = !whole || words.empty() || words.find("SPDX-") != std::string::npos;
  }
  return faults;
}

/// The word "no" where "not a" is meant: after is or are, but not after there, nor before a
/// comparison (longer). Line breaks, quotes and the marks of comments join words; any other sign
/// parts them.
std::vector<Fault> denials(std::string_view text) {
  static const std::set<std::string> comparisons{
      "longer",   "more",    "less",   "fewer",  "smaller", "larger",  "finer",  "coarser",
      "narrower", "wider",   "higher", "lower",  "later",   "faster",  "slower", "further",
      "farther",  "earlier", "nearer", "closer", "worse",   "shorter", "better"};
  std::array<std::string, 4> last;  // the words so far; empty: parted from the next one
  std::vector<Fault> faults;
  std::string word;
  std::size_t line = 1;
  const auto take = [&](const std::string& next) {
    for (std::size_t k = 0; k + 1 < last.size(); ++k) last[k] = last[k + 1];
    last.back() = next;
    if (last[2] == "no" && (last[1] == "is" || last[1] == "are") && last[0] != "there" &&
        !next.empty() && !comparisons.contains(next))
      faults.push_back({line, last[1] + " no " + next});
  };
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    if (!word.empty()) take(word);
    word.clear();
    if (c == '\n') ++line;
    if (std::string_view(" \n\t\"'`/#*").find(c) == std::string_view::npos) take("");
  }
  if (!word.empty()) take(word);
  return faults;
}

/// What begins a comment in a file that people write; empty: the file has none.
std::string mark_of(const fs::path& file) {
  const std::string ending = file.extension();
  for (const char* each : {".hpp", ".cpp", ".h", ".c", ".js", ".mjs"})
    if (ending == each) return "//";
  for (const char* each : {"", ".py", ".sh", ".cmake", ".yaml", ".txt", ".program"})
    if (ending == each) return "#";
  return "";
}

bool is_read(const fs::path& file) {
  return !mark_of(file).empty() || file.extension() == ".md" || file.extension() == ".html";
}

std::vector<fs::path> files_that_people_read() {
  std::vector<fs::path> found;
  for (const fs::directory_entry& each : fs::directory_iterator(root))
    if (each.path().extension() == ".md") found.push_back(each.path());
  for (const char* top : {"src", "adapters", "cases", "tests", "scripts", "reports"})
    for (const fs::directory_entry& each : fs::recursive_directory_iterator(root / top))
      if (each.is_regular_file() && is_read(each.path()) &&
          !each.path().string().starts_with((root / "reports/out").string()))
        found.push_back(each.path());
  return found;
}

TEST(Words, CommentsBeginWithASubject) {
  std::size_t read = 0;
  for (const fs::path& file : files_that_people_read()) {
    const std::string mark = mark_of(file);
    if (mark.empty()) continue;
    ++read;
    for (const Fault& each : headless_comments(tests::text_of(file), mark))
      ADD_FAILURE() << file.lexically_relative(root).string() << ":" << each.line << ": "
                    << each.words << ": say what it is, with a noun and a verb";
  }
  EXPECT_GE(read, 1000U) << "the comments were not read";
}

TEST(Words, WhatIsDeniedIsDeniedByNot) {
  std::size_t read = 0;
  for (const fs::path& file : files_that_people_read()) {
    ++read;
    for (const Fault& each : denials(tests::text_of(file)))
      ADD_FAILURE() << file.lexically_relative(root).string() << ":" << each.line << ": "
                    << each.words << ": write \"is not a\" or \"are not\"";
  }
  EXPECT_GE(read, 1000U) << "the files were not read";
}

TEST(Words, ACommentWithoutANounIsFoundWhereItBegins) {
  const std::string text =
      "// SPDX\n"
      "/// Of the last step.\n"
      "int a;  /"
      "//< Those of b\n"
      "int b;  ///< of the step before\n"
      "// The name of a file.\n"
      "// That it begins a line is chance.\n"
      "//\n"
      "//   By name.\n"
      "x = \"/// Of a string\";\n"
      "// Offers more.\n";
  const std::vector<Fault> found = headless_comments("// SPDX-" + text.substr(3), "//");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0], (Fault{2, "/// Of the last step."}));
  EXPECT_EQ(found[1].line, 3U);
  EXPECT_EQ(found[2].line, 8U);
  const std::vector<Fault> script = headless_comments("# Of a script.\nrun  # by name\n", "#");
  EXPECT_EQ(script, (std::vector<Fault>{{1, "# Of a script."}}));
}

/// The made texts have a tilde for "no": this file is read too.
std::string made(std::string text) {
  for (std::size_t at = text.find('~'); at != std::string::npos; at = text.find('~', at))
    text.replace(at, 1, "no");
  return text;
}

TEST(Words, ADenialIsFoundAcrossLinesAndLiterals) {
  const auto found = [](const std::string& text) { return denials(made(text)); };
  const auto fault = [](std::size_t line, const std::string& words) {
    return std::vector<Fault>{{line, made(words)}};
  };
  EXPECT_EQ(found("/// Throws for what is ~\n/// file.\n"), fault(2, "is ~ file"));
  EXPECT_EQ(found("fail(\"{}: are \"\n     \"~ numbers\");"), fault(2, "are ~ numbers"));
  EXPECT_EQ(found("A run that **is ~** solution"), fault(1, "is ~ solution"));
  for (const char* fine : {"There is ~ file.", "where there\n// are ~ numbers", "is ~ longer",
                           "are ~ more accurate", "The answer is ~. Why", "as it is, ~ matter"})
    EXPECT_TRUE(found(fine).empty()) << fine;
}

}  // namespace
}  // namespace odeum::rules::words_test
