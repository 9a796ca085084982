// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace odeum::report {
namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path) {
  throw FileError(fmt::format("{} {}: {}", what, path.string(), std::strerror(errno)));
}

// All of the text, or an exception: a full disk shows here, or when the file is synced.
void write_all(int file, std::string_view text, const std::filesystem::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write", path);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

OutputFolder::OutputFolder(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error)
    throw FileError(fmt::format("cannot make folder {}: {}", path_.string(), error.message()));
  const auto lock_path = path_ / ".lock";
  lock_ = ::open(lock_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (lock_ < 0) fail("cannot open", lock_path);
  // The lock goes with the process, however it ends; the file's text only names the holder.
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    const std::string holder = read_file(lock_path);
    ::close(lock_);
    throw FileError(fmt::format("folder {} is in use by {}", path_.string(),
                                holder.empty() ? "another run" : holder));
  }
  char host[256] = "this machine";
  ::gethostname(host, sizeof host - 1);
  const std::string holder = fmt::format("process {} on {}", ::getpid(), host);
  if (::ftruncate(lock_, 0) != 0) fail("cannot write", lock_path);
  write_all(lock_, holder, lock_path);
}

OutputFolder::~OutputFolder() {
  // The file stays: removing it would let a run that has just opened it lock a name that is gone.
  if (::ftruncate(lock_, 0) == 0) ::close(lock_);
}

void OutputFolder::write(std::string_view name, std::string_view text) const {
  const std::filesystem::path relative(name);
  for (const auto& part : relative)
    if (part == ".." || part.is_absolute())
      throw FileError(fmt::format("{} would leave the output folder", name));
  const auto target = path_ / relative;
  std::error_code error;
  std::filesystem::create_directories(target.parent_path(), error);
  if (error)
    throw FileError(
        fmt::format("cannot make folder {}: {}", target.parent_path().string(), error.message()));
  auto temporary = target;
  temporary += ".tmp";  // one run a folder, so a leftover of a killed one is simply replaced
  ::unlink(temporary.c_str());
  const int file =
      ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (file < 0) fail("cannot create", temporary);
  try {
    write_all(file, text, temporary);
    if (::fsync(file) != 0 && errno != EINVAL) fail("cannot write", temporary);
  } catch (...) {
    ::close(file);
    ::unlink(temporary.c_str());
    throw;
  }
  if (::close(file) != 0 || ::rename(temporary.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    ::unlink(temporary.c_str());
    errno = reason;
    fail("cannot write", target);
  }
}

namespace {

// Tabs, line breaks and backslashes escaped, so that a record is one line.
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

}  // namespace

Journal::Journal(const OutputFolder& folder, const std::string& study,
                 const std::string& fingerprint, bool resume)
    : path_(folder.path() / ("." + study + ".journal")) {
  const std::string heading = "odeum journal\t" + escape(fingerprint);
  std::string kept = heading + "\n";
  if (resume) {
    const std::string text = read_file(path_);
    std::string_view rest = text;
    bool first = true;
    for (std::size_t end; (end = rest.find('\n')) != std::string_view::npos;
         rest.remove_prefix(end + 1)) {
      const std::string_view line = rest.substr(0, end);
      if (first && line != heading) break;
      if (const std::size_t tab = line.find('\t'); !first && tab != std::string_view::npos) {
        held_[unescape(line.substr(0, tab))] = unescape(line.substr(tab + 1));
        kept += std::string(line) + "\n";
      }
      first = false;
    }
  }
  ::unlink(path_.c_str());
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (file_ < 0) fail("cannot create", path_);
  write_all(file_, kept, path_);
}

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

std::optional<std::string> Journal::find(const std::string& key) const {
  const auto found = held_.find(key);
  if (found == held_.end()) return std::nullopt;
  return found->second;
}

void Journal::add(const std::string& key, const std::string& result) {
  const std::string line = escape(key) + '\t' + escape(result) + '\n';
  const std::lock_guard lock(mutex_);
  write_all(file_, line, path_);
}

void Journal::finish() { ::unlink(path_.c_str()); }

}  // namespace odeum::report
