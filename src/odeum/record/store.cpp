// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <vector>

#include "odeum/core/checksum.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::record {
namespace {

namespace fs = std::filesystem;

// Tabs, line breaks and backslashes escaped, so that a result is one line.
std::string escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\\\";
    else if (c == '\n')
      escaped += "\\n";
    else if (c == '\t')
      escaped += "\\t";
    else
      escaped += c;
  }
  return escaped;
}

std::string unescape(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      plain += text[i];
      continue;
    }
    const char code = text[++i];
    plain += code == 'n' ? '\n' : code == 't' ? '\t' : code;
  }
  return plain;
}

std::string sum_of(std::string_view text) { return fmt::format("{:016x}", checksum(text)); }

std::string line_of(const std::string& text) { return sum_of(text) + '\t' + text + '\n'; }

/// The text of a line without its sum; nothing where they do not agree.
std::optional<std::string_view> checked(std::string_view line) {
  const std::size_t tab = line.find('\t');
  if (tab == std::string_view::npos) return std::nullopt;
  const std::string_view text = line.substr(tab + 1);
  if (line.substr(0, tab) != sum_of(text)) return std::nullopt;
  return text;
}

std::string reason_of(const fs::path& path) {
  return fmt::format("{}: {}", path.string(), std::strerror(errno));
}

}  // namespace

Store::Store(fs::path folder, std::uintmax_t most_bytes) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) {
    problem_ = fmt::format("{}: {}", folder_.string(), error.message());
    return;
  }
  struct File {
    fs::file_time_type used;
    std::uintmax_t size;
    fs::path path;
  };
  std::vector<File> files;
  std::uintmax_t total = 0;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    if (entry.path().extension() != extension) continue;
    std::error_code gone;  // another run may remove files too
    const File file{entry.last_write_time(gone), entry.file_size(gone), entry.path()};
    if (gone) continue;
    total += file.size;
    files.push_back(file);
  }
  std::ranges::sort(files, [](const File& a, const File& b) { return a.used < b.used; });
  for (const File& file : files) {
    if (total <= most_bytes) break;
    if (fs::remove(file.path, error)) total -= file.size;
  }
}

fs::path Store::file_of(const std::string& dependencies) const {
  return folder_ /
         fmt::format("{}{}{}", sum_of(dependencies), sum_of("b" + dependencies), extension);
}

Store::Results& Store::results_of(const std::string& dependencies) {
  const auto [place, is_new] = held_.try_emplace(dependencies);
  if (!is_new) return place->second;
  const fs::path own = file_of(dependencies);
  read(own, dependencies, place->second);
  for (const fs::path& folder : also_) read(folder / own.filename(), dependencies, place->second);
  return place->second;
}

void Store::read(const fs::path& path, const std::string& dependencies, Results& into) {
  const std::string text = text_of_file(path).value_or("");
  std::string_view rest = text;
  bool first = true;
  for (std::size_t end = 0; (end = rest.find('\n')) != std::string_view::npos;
       rest.remove_prefix(end + 1)) {
    const auto line = checked(rest.substr(0, end));
    if (first && (!line || *line != escape(dependencies))) return;
    first = false;
    if (!line) continue;
    if (const std::size_t tab = line->find('\t'); tab != std::string_view::npos)
      into[unescape(line->substr(0, tab))] = unescape(line->substr(tab + 1));
  }
  std::error_code ignored;
  if (!text.empty()) fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
}

std::optional<std::string> Store::take(const std::string& dependencies, const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto node = results_of(dependencies).extract(key);
  if (!node) return std::nullopt;
  ++taken_;
  return std::move(node.mapped());
}

void Store::add(const std::string& dependencies, const std::string& key,
                const std::string& result) {
  const std::string line = line_of(escape(key) + '\t' + escape(result));
  const std::lock_guard lock(mutex_);
  if (!problem_.empty()) return;
  append(file_of(dependencies), dependencies, line);
  if (problem_.empty()) ++added_;
}

void Store::append(const fs::path& path, const std::string& dependencies, const std::string& line) {
  const OpenFile file(
      ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
  struct stat before {};
  // Another run may write to the same file.
  if (file.get() < 0 || ::flock(file.get(), LOCK_EX) != 0 || ::fstat(file.get(), &before) != 0) {
    problem_ = reason_of(path);
    return;
  }
  // After a line that was not written whole, a new one begins.
  std::string text = before.st_size == 0 ? line_of(escape(dependencies)) + line : line;
  if (before.st_size > 0) {
    std::ifstream in(path, std::ios::binary);
    in.seekg(-1, std::ios::end);
    if (in.get() != '\n') text.insert(0, "\n");
  }
  if (write_all(file, text)) return;
  problem_ = reason_of(path);
  // Where that fails too, the line is told by its sum.
  [[maybe_unused]] const int cut = ::ftruncate(file.get(), before.st_size);
}

}  // namespace odeum::record
