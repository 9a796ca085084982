// SPDX-License-Identifier: BSD-3-Clause
#include "source_tree.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>

#include "support/temporary_folder.hpp"

namespace odeum::rules {
namespace {

namespace fs = std::filesystem;
using tests::text_of;

constexpr std::size_t file_limit = 300, kernel_limit = 150, function_limit = 60;
constexpr std::string_view reason_mark = "// long: ";

/// The room of a file, and its rank; siblings of `<name>` have equal rank.
struct Place {
  std::string room;
  std::size_t rank;
};

std::optional<Place> place_of(const std::string& file, const std::vector<std::string>& rooms) {
  const std::string folder = fs::path(file).parent_path().string();
  for (std::size_t rank = 0; rank < rooms.size(); ++rank) {
    const std::string& room = rooms[rank];
    if (const std::size_t name = room.find("/<name>"); name != std::string::npos) {
      const std::string above = room.substr(0, name + 1);
      if (folder.starts_with(above))
        return Place{folder.substr(0, folder.find('/', above.size())), rank};
    } else if (folder == room) {
      return Place{room, rank};
    }
  }
  return {};
}

/// The file that an include names, relative to the root; none where it is not a file of the
/// checkout.
std::optional<std::string> resolve(const fs::path& root, const std::string& file,
                                   const std::string& included) {
  // The one generated header that stands for files of a room.
  if (included == "odeum_methods.hpp") return "src/odeum/methods/odeum_methods.hpp";
  for (const fs::path& base :
       {fs::path(file).parent_path(), fs::path("src"), fs::path("cases"), fs::path("adapters")})
    if (fs::exists(root / base / included)) return (base / included).lexically_normal().string();
  return {};
}

/// What is wrong with an include; empty where nothing is.
std::string include_fault(const std::string& from, const std::string& to,
                          const std::vector<std::string>& rooms) {
  const auto lower = place_of(from, rooms), higher = place_of(to, rooms);
  if (!higher) return "of no room";
  if (higher->rank > lower->rank) return lower->room + " stands below " + higher->room;
  if (higher->rank == lower->rank && higher->room != lower->room)
    return lower->room + " and " + higher->room + " stand side by side";
  if (from.starts_with("src/") && !to.starts_with("src/")) return "src includes from itself only";
  return "";
}

/// The text with comments, strings and characters made blank; newlines stay.
std::string without_literals(std::string_view text) {
  std::string out(text);
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, out.size()); ++i)
      if (out[i] != '\n') out[i] = ' ';
    return to;
  };
  const auto after = [&](std::string_view mark, std::size_t from) {
    const std::size_t found = text.find(mark, from);
    return found == std::string_view::npos ? text.size() : found + mark.size();
  };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (text.substr(i).starts_with("//")) {
      i = blank(i, after("\n", i) - 1) + 1;
    } else if (text.substr(i).starts_with("/*")) {
      i = blank(i, after("*/", i + 2));
    } else if (text.substr(i).starts_with("R\"")) {
      const std::size_t open = text.find('(', i);
      std::string close = ")";
      close.append(text, i + 2, open - i - 2).append("\"");
      i = blank(i, after(close, open));
    } else if (c == '"' ||
               (c == '\'' && (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1]))))) {
      std::size_t end = i + 1;
      while (end < text.size() && text[end] != c) end += text[end] == '\\' ? 2 : 1;
      i = blank(i, end + 1);
    } else {
      ++i;
    }
  }
  return out;
}

/// Whether the text before an opening brace makes it a function's: a parameter list, and neither a
/// scope nor an initialiser.
bool opens_function(const std::string& head) {
  static const std::regex scope(
      R"(^\s*(template\s*<[^{]*>\s*)?(inline\s+)?(namespace|class|struct|union|enum|extern)\b)");
  static const std::regex initialiser(R"(=\s*$|=\s*[\w:<>, ]+$)");
  return head.find('(') != std::string::npos && !std::regex_search(head, scope) &&
         !std::regex_search(head, initialiser);
}

}  // namespace

std::vector<std::string> rooms_of(const fs::path& contributing) {
  static const std::regex row(R"(^\| `([^`]+)` \|.*)");
  std::vector<std::string> rooms;
  std::istringstream lines(text_of(contributing));
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) inside = line == "## Rooms";
    std::smatch match;
    if (inside && std::regex_match(line, match, row)) rooms.push_back(match[1]);
  }
  return rooms;
}

std::vector<std::string> sources_of(const fs::path& root, const std::vector<std::string>& folders) {
  std::vector<std::string> files;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
        files.push_back(entry.path().lexically_relative(root).string());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Violation> upward_includes(const fs::path& root,
                                       const std::vector<std::string>& rooms) {
  static const std::regex include(R"(^\s*#\s*include\s*["<]([^">]+)[">].*)");
  std::vector<Violation> found;
  for (const std::string& file : sources_of(root, {"src", "adapters", "cases"})) {
    if (!place_of(file, rooms)) {
      found.push_back({file, 1, file, "lies in no room of the table in CONTRIBUTING.md"});
      continue;
    }
    std::istringstream lines(text_of(root / file));
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      const auto included = resolve(root, file, match[1]);
      if (!included) continue;
      if (const std::string fault = include_fault(file, *included, rooms); !fault.empty())
        found.push_back({file, number, file + " -> " + *included, fault});
    }
  }
  return found;
}

std::vector<Violation> long_files(const fs::path& root) {
  std::vector<Violation> found;
  for (const std::string& file : sources_of(root, {"src", "adapters", "cases", "tests"})) {
    const std::string text = text_of(root / file);
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    const std::size_t limit = file.starts_with("src/odeum/kernel/") ? kernel_limit : file_limit;
    // A reason at the head of a file, not inside of a function.
    if (lines > limit && text.substr(0, text.find('{')).find(reason_mark) == std::string::npos)
      found.push_back(
          {file, lines, file,
           std::string("a file of more than ").append(std::to_string(limit)).append(" lines")});
  }
  return found;
}

std::vector<Violation> long_functions_of(const std::string& file, std::string_view text) {
  const std::string code = without_literals(text);
  std::vector<Violation> found;
  std::vector<bool> scopes;  // of the braces open: whether each is a function's
  std::size_t function_start = 0, function_line = 0, line = 1, head = 0;
  std::string function_head;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const bool inside = std::find(scopes.begin(), scopes.end(), true) != scopes.end();
    if (code[i] == '\n') {
      ++line;
      // A preprocessor directive belongs to no declaration.
      if (head < i && code.find_first_not_of(" \n", head) < i &&
          code[code.find_first_not_of(" \n", head)] == '#')
        head = i;
    } else if (code[i] == '{') {
      const std::string before = code.substr(head, i - head);
      scopes.push_back(!inside && opens_function(before));
      if (scopes.back()) {
        function_start = i;
        function_line = line;
        function_head = before;
      }
      head = i + 1;
    } else if (code[i] == '}') {
      if (!scopes.empty() && scopes.back() && line - function_line + 1 > function_limit &&
          text.substr(function_start, i - function_start).find(reason_mark) ==
              std::string_view::npos) {
        std::smatch name;
        std::regex_search(function_head, name, std::regex(R"(([~\w]+)(\s*=\s*\[[^\]]*\])?\s*\()"));
        found.push_back({file, function_line, file + " " + name[1].str(),
                         std::string("a function of ")
                             .append(std::to_string(line - function_line + 1))
                             .append(" lines")});
      }
      if (!scopes.empty()) scopes.pop_back();
      head = i + 1;
    } else if (code[i] == ';') {
      head = i + 1;
    }
  }
  return found;
}

std::vector<Violation> long_functions(const fs::path& root) {
  std::vector<Violation> found;
  for (const std::string& file : sources_of(root, {"src", "adapters", "cases"}))
    for (Violation& each : long_functions_of(file, text_of(root / file)))
      found.push_back(std::move(each));
  return found;
}

}  // namespace odeum::rules
