// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Reads the C++ files of a checkout and finds what breaks the rules of CONTRIBUTING.md.
namespace odeum::rules {

/// A place that breaks a rule. `key` names it without line numbers, for the list of known ones.
struct Violation {
  std::string file;
  std::size_t line;
  std::string key, rule;
};

/// The rooms, lowest first: the folders in the table "Rooms" of CONTRIBUTING.md, as in the rows
/// "| `src/odeum/problem` | ...". Each row of a folder that ends with `/<name>` stands for all of
/// its subfolders, which are rooms of equal rank and do not include one another.
std::vector<std::string> rooms_of(const std::filesystem::path& contributing);

/// The C++ files below the folders of `root`, as paths relative to it, sorted.
std::vector<std::string> sources_of(const std::filesystem::path& root,
                                    const std::vector<std::string>& folders);

/// Includes from a lower room to a higher one, files of no room, and files in src that include from
/// outside of it.
std::vector<Violation> upward_includes(const std::filesystem::path& root,
                                       const std::vector<std::string>& rooms);

/// Files over 300 lines; in src/odeum/kernel over 150. A comment `// long: <reason>` allows one.
std::vector<Violation> long_files(const std::filesystem::path& root);

/// Functions of more than 60 lines from brace to brace. A comment `// long: <reason>` inside allows
/// one.
std::vector<Violation> long_functions(const std::filesystem::path& root);
std::vector<Violation> long_functions_of(const std::string& file, std::string_view text);

}  // namespace odeum::rules
