// SPDX-License-Identifier: BSD-3-Clause
// Every column of every file that a study writes is documented in its folder's columns.md or,
// where it is the same everywhere, in reports/columns.md, and nothing else is.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "odeum/studies/study.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::study::columns_test {
namespace {

namespace fs = std::filesystem;
using tests::text_of;
using Columns = std::map<std::string, std::set<std::string>>;  // by file

std::set<std::string> matches(const std::string& text, const char* pattern) {
  std::set<std::string> found;
  const std::regex expression(pattern);
  for (auto it = std::sregex_iterator(text.begin(), text.end(), expression);
       it != std::sregex_iterator(); ++it)
    found.insert((*it)[1]);
  return found;
}

Columns written() {
  Columns columns;
  for (const auto& study : make_studies())
    for (const auto& [file, fields] : study->files())
      for (const record::Field& field : fields) columns[file].insert(field.column);
  return columns;
}

Columns documented() {
  Columns columns;
  const fs::path root(ODEUM_SOURCE_DIR);
  std::vector<fs::path> files{root / "reports/columns.md"};
  for (const auto& study : fs::directory_iterator(root / "src/odeum/studies"))
    if (study.is_directory()) files.push_back(study.path() / "columns.md");
  for (const fs::path& file : files) {
    std::string section;
    std::istringstream in(text_of(file));
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("## ")) section = line.substr(3);
      if (!line.starts_with("- `")) continue;
      columns[section].merge(matches(line.substr(0, line.find(':')), "`(\\w+)`"));
    }
  }
  return columns;
}

TEST(Columns, AreDocumentedOnce) {
  const Columns files = written();
  Columns words = documented();
  const std::set<std::string> everywhere = words["Every file"];
  ASSERT_GE(files.size(), 20U) << "the studies were not found";
  std::set<std::string> used{"schema"};
  for (const auto& [file, columns] : files) {
    EXPECT_TRUE(words.contains(file)) << "no columns.md has a section " << file;
    ASSERT_GE(columns.size(), 3U) << file;
    for (const std::string& column : columns) {
      used.insert(column);
      EXPECT_NE(everywhere.contains(column), words[file].contains(column))
          << file << ": " << column << " is to be documented once";
    }
    for (const std::string& column : words[file])
      EXPECT_TRUE(columns.contains(column)) << file << " has no column " << column;
  }
  for (const std::string& column : everywhere)
    EXPECT_TRUE(used.contains(column)) << "no file has a column " << column;
}

}  // namespace
}  // namespace odeum::study::columns_test
