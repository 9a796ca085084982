// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/shared_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace odeum::report {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> find_shared_folder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  if (none) return {};
  // Beside the program in a build, beside its folder for the tests of a build, and where it is
  // installed.
  for (const fs::path& base : {program.parent_path(), program.parent_path().parent_path()})
    if (fs::is_directory(base / "share/odeum/viewer", none)) return base / "share/odeum";
  return {};
}

fs::path required_folder() {
  const auto folder = shared_folder();
  if (!folder)
    throw record::FileError(
        "the files of the page were not found: share/odeum stands neither beside the program nor "
        "beside its folder");
  return *folder;
}

/// `text` with each mark {{...}} replaced by `part` of what stands in it.
template <class Part>
std::string replaced(std::string_view text, const Part& part) {
  std::string result;
  for (std::size_t at = 0;;) {
    const std::size_t begin = text.find("{{", at);
    const std::size_t end = text.find("}}", begin);
    if (begin == std::string_view::npos || end == std::string_view::npos)
      return result.append(text.substr(at));
    result.append(text.substr(at, begin - at))
        .append(part(text.substr(begin + 2, end - begin - 2)));
    at = end + 2;
  }
}

}  // namespace

std::optional<fs::path> shared_folder() {
  static const std::optional<fs::path> folder = find_shared_folder();
  return folder;
}

std::string shared_text(const fs::path& file) {
  const auto folder = shared_folder();
  if (!folder) return {};
  std::ifstream in(*folder / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_viewer(const record::OutputFolder& folder, const std::vector<std::string>& files) {
  const fs::path shared = required_folder();
  for (const char* part : {"viewer", "libraries"}) {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(shared / part))
      if (entry.is_regular_file() && entry.path().extension() != ".html")
        names.push_back(entry.path().filename());
    std::ranges::sort(names);
    for (const fs::path& name : names)
      folder.write("viewer/" + name.string(), shared_text(part / name));
  }
  // The line that holds {{file}} stands once for each file.
  std::string page = shared_text("viewer/index.html");
  const std::size_t mark = page.find("{{file}}"), begin = page.rfind('\n', mark) + 1,
                    end = page.find('\n', mark) + 1;
  if (mark == std::string::npos) throw record::FileError("viewer/index.html has no line of files");
  const std::string line = page.substr(begin, end - begin);
  std::string lines;
  for (const std::string& file : files)
    lines += replaced(line, [&](std::string_view) { return file; });
  folder.write("index.html", page.replace(begin, end - begin, lines));
}

std::string filled_template(const fs::path& file, std::string_view data) {
  required_folder();
  return replaced(shared_text(file), [&](std::string_view mark) {
    constexpr std::string_view include = "include ";
    if (mark == "data") return std::string(data);
    if (mark.starts_with(include))
      return shared_text(file.parent_path() / mark.substr(include.size()));
    return "{{" + std::string(mark) + "}}";
  });
}

}  // namespace odeum::report
