// SPDX-License-Identifier: BSD-3-Clause
// What the documents refer to is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace odeum::rules::documents_test {
namespace {

namespace fs = std::filesystem;
using tests::text_of;

const fs::path root = ODEUM_SOURCE_DIR;

std::vector<fs::path> documents() {
  std::vector<fs::path> found;
  std::vector<fs::path> folders{root,
                                root / "reports",
                                root / "reports/docs",
                                root / "reports/findings",
                                root / "reports/measured",
                                root / "cases/problems",
                                root / "cases/scenes",
                                root / "cases/tableaus"};
  for (const fs::directory_entry& study : fs::directory_iterator(root / "src/odeum/studies"))
    if (study.is_directory()) folders.push_back(study.path());
  for (const fs::path& folder : folders)
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

std::set<std::string> all_matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator each(text.begin(), text.end(), pattern), end; each != end; ++each)
    found.insert((*each)[1]);
  return found;
}

/// The address that a heading has: small letters, digits and hyphens.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return anchor;
}

bool has_heading(const std::string& text, const std::string& anchor) {
  static const std::regex heading("(?:^|\n)#+ ([^\n]+)");
  for (const std::string& each : all_matches(text, heading))
    if (anchor_of(each) == anchor) return true;
  return false;
}

TEST(Documents, LinksLeadSomewhere) {
  static const std::regex link("\\]\\(([^)\\s]+)\\)");
  std::size_t links = 0;
  for (const fs::path& document : documents()) {
    const std::string text = text_of(document);
    for (const std::string& target : all_matches(text, link)) {
      if (target.find("://") != std::string::npos) continue;
      // The text of a page links to other views of the report, which the test report_page opens.
      const bool of_page = document.string().find("/src/odeum/") != std::string::npos;
      if (of_page && (target.starts_with("#") || target == "findings.md")) continue;
      ++links;
      const std::size_t hash = std::min(target.find('#'), target.size());
      const fs::path file = hash ? document.parent_path() / target.substr(0, hash) : document;
      EXPECT_TRUE(fs::exists(file)) << document << " links to " << target;
      if (hash < target.size()) {
        EXPECT_TRUE(has_heading(text_of(file), target.substr(hash + 1)))
            << document << " links to " << target << ", no such heading";
      }
    }
  }
  EXPECT_GE(links, 20U) << "the documents were not read";
}

// Paths of the tree in backquotes: `src/odeum/judge/amplification.hpp`.
TEST(Documents, FilesThatAreNamedExist) {
  static const std::regex path(
      "`((?:src|cases|adapters|tests|reports|scripts)/[a-zA-Z0-9_./-]*[a-zA-Z0-9_])`");
  std::size_t paths = 0;
  for (const fs::path& document : documents()) {
    if (document.filename() == "CHANGELOG.md") continue;  // names what was there at its time
    for (const std::string& each : all_matches(text_of(document), path)) {
      if (each.starts_with("reports/out")) continue;  // written by a run
      ++paths;
      EXPECT_TRUE(fs::exists(root / each)) << document << " names " << each;
    }
  }
  EXPECT_GE(paths, 20U) << "the documents were not read";
}

/// What begins a comment, by the ending of a file; a document is read as a whole.
const std::map<std::string, std::string> comment_marks{
    {".hpp", "// "}, {".cpp", "// "},  {".h", "// "},   {".c", "// "},
    {".js", "// "},  {".mjs", "// "},  {".py", "# "},   {".sh", "# "},
    {".txt", "# "},  {".cmake", "# "}, {".yaml", "# "}, {".md", ""}};

/// The comments of a file; nothing where it may have none.
std::string comments_of(const fs::path& file) {
  const auto mark = comment_marks.find(file.extension().string());
  if (mark == comment_marks.end()) return "";
  std::istringstream in(text_of(file));
  std::string comments;
  for (std::string line; std::getline(in, line);)
    if (const std::size_t at = line.find(mark->second); at != std::string::npos)
      comments += line.substr(at) + '\n';
  return comments;
}

/// Whether a comment of a file in `folder` may name it so: from the root, or from a folder whose
/// files are often named.
bool is_in_tree(const fs::path& path, const fs::path& folder) {
  for (const fs::path& from : {root, folder, root / "src/odeum", root / "adapters",
                               root / "reports", root / "tests", root / "src"})
    if (fs::exists(from / path)) return true;
  return false;
}

// Six comments named files that had been moved.
TEST(Documents, FilesInCommentsExist) {
  static const std::regex path(
      "(?:^|[^\\w/.<>$}*-])((?:[\\w-]+/"
      ")+[\\w-]+\\.(?:hpp|cpp|h|cmake|yaml|md|m?js|py|sh|css))(?![\\w/])");
  const std::set<std::string> elsewhere{"odeum/plugin.h",
                                        "build/portable/CPackConfig.cmake",  // made by the build
                                        "arkode/arkode_butcher.h"};          // a header of SUNDIALS
  std::size_t paths = 0;
  for (const char* top : {"src", "adapters", "cases", "tests", "reports", "scripts"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file() ||
          entry.path().string().starts_with((root / "reports/out").string()))
        continue;
      for (const std::string& each : all_matches(comments_of(entry.path()), path)) {
        if (each.starts_with("reports/out") || elsewhere.contains(each)) continue;
        ++paths;
        EXPECT_TRUE(is_in_tree(each, entry.path().parent_path()))
            << entry.path() << " names " << each;
      }
    }
  EXPECT_GE(paths, 100U) << "the comments were not read";
}

/// The text without the tables that scripts/measured makes, which are counted in `tables`.
std::string without_measured(std::string text, std::size_t& tables) {
  const std::string open = "<!-- measured ", close = "<!-- end -->";
  for (std::size_t from = text.find(open); from != std::string::npos; from = text.find(open)) {
    const std::size_t to = text.find(close, from);
    if (to == std::string::npos) ADD_FAILURE() << text.substr(from, 60) << " has no end";
    EXPECT_EQ(text.find(open, from + 1), text.find(open, to)) << "a table within another";
    if (to == std::string::npos) break;
    text.erase(from, to + close.size() - from);
    ++tables;
  }
  return text;
}

// The data are the one place of a measured time: a number typed beside them would stay as it is.
TEST(Documents, SpeedHasNoNumberTypedByHand) {
  std::size_t tables = 0;
  const std::string text = without_measured(text_of(root / "reports/speed.md"), tables);
  EXPECT_EQ(tables, 1U);
  static const std::regex number(
      "(\\d+\\.\\d+|\\d+ ?(?:%|ns|us|ms|s|kB|MB|times|x)(?![a-z0-9_-])(?! \\d))");
  for (const std::string& each : all_matches(text, number)) ADD_FAILURE() << each;
}

// A group without its revision, date and processor, or a group that is gone, is not a measurement.
TEST(Documents, SpeedSaysWhereEachGroupWasMeasured) {
  std::istringstream rows(text_of(root / "reports/measured/speed.csv"));
  static const std::regex place(
      "1,([a-z]+,[A-Z0-9-]*),.*scripts/bench "
      "[^,]+,[0-9a-f]{7,},\\d{4}-\\d\\d-\\d\\d,[^,]+,\\d+,.*");
  std::set<std::string> groups;
  std::string line;
  std::getline(rows, line);
  while (std::getline(rows, line)) {
    std::smatch match;
    EXPECT_TRUE(std::regex_match(line, match, place)) << line;
    if (!match.empty()) groups.insert(match[1]);
  }
  EXPECT_GE(groups.size(), 20U);
}

// What each day did is in the history; a user wants to know what a version brings.
TEST(Documents, TheChangelogIsByVersion) {
  static const std::regex heading("(?:^|\n)(#+ [^\n]+)"),
      allowed("# Changelog|## \\d+\\.\\d+\\.\\d+, .+|### (Added|Changed|Fixed|Removed)");
  const std::set<std::string> headings = all_matches(text_of(root / "CHANGELOG.md"), heading);
  EXPECT_GE(headings.size(), 4U);
  for (const std::string& each : headings) EXPECT_TRUE(std::regex_match(each, allowed)) << each;
}

TEST(Documents, TheReadmeHasNoNumberThatNobodyReads) {
  static const std::regex digits("(\\d[\\d.]{9,}\\d)");
  for (const std::string& each : all_matches(text_of(root / "README.md"), digits))
    ADD_FAILURE() << each;
}

// People read all of it but the reference, which a program writes and nobody reads from top to
// bottom.
TEST(Documents, AreShortEnoughToRead) {
  constexpr std::size_t most = 36'000;
  std::map<std::string, std::size_t> counts;
  const auto count = [&](const fs::directory_entry& entry) {
    const std::string file = entry.path().lexically_relative(root).string();
    if (entry.path().extension() != ".md" || file.starts_with("reports/out") ||
        file == "reports/docs/reference.md")
      return;
    std::istringstream words(text_of(entry.path()));
    counts[file] =
        static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(words), {}));
  };
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) count(entry);
  for (const char* folder : {"reports", "cases"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
      count(entry);
  std::size_t all = 0;
  std::string list;
  for (const auto& [file, words] : counts) {
    all += words;
    list += '\n' + std::to_string(words) + ' ' + file;
  }
  EXPECT_GE(counts.size(), 20U) << "the documents were not read";
  EXPECT_LE(all, most) << all << " words, of which people should read " << most
                       << " at most; data go to reports/measured:" << list;
}

}  // namespace
}  // namespace odeum::rules::documents_test
