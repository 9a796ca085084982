// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include "odeum/record/gzip.hpp"

namespace odeum::record {
namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path) {
  throw FileError(fmt::format("{} {}: {}", what, path.string(), std::strerror(errno)));
}

// Writes all of the text or throws: a full disk is reported here, or when the file is synced.
void write_all(int file, std::string_view text, const std::filesystem::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write", path);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

// Every file is written under this name first. There is one run per folder, so a leftover of a
// killed run is replaced.
std::filesystem::path temporary_of(std::filesystem::path path) { return path += ".tmp"; }

int create(const std::filesystem::path& path) {
  ::unlink(path.c_str());
  const int file =
      ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (file < 0) fail("cannot create", path);
  return file;
}

void replace(const std::filesystem::path& target) {
  if (::rename(temporary_of(target).c_str(), target.c_str()) != 0) fail("cannot write", target);
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

bool OpenFile::close() {
  const int descriptor = std::exchange(descriptor_, -1);
  return descriptor < 0 || ::close(descriptor) == 0;
}

OutputFolder::OutputFolder(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error)
    throw FileError(fmt::format("cannot make folder {}: {}", path_.string(), error.message()));
  const auto lock_path = path_ / ".lock";
  lock_.reset(::open(lock_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644));
  if (lock_.get() < 0) fail("cannot open", lock_path);
  // The lock ends with the process; the file's text only names the holder.
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) fail("cannot lock", lock_path);
    const std::string holder = read_file(lock_path);
    throw FileError(fmt::format("folder {} is in use by {}", path_.string(),
                                holder.empty() ? "another run" : holder));
  }
  char host[256] = "this machine";
  ::gethostname(host, sizeof host - 1);
  const std::string holder = fmt::format("process {} on {}", ::getpid(), host);
  if (::ftruncate(lock_.get(), 0) != 0) fail("cannot write", lock_path);
  write_all(lock_.get(), holder, lock_path);
}

OutputFolder::~OutputFolder() {
  // The file is not removed: another run may have opened it and would lock a deleted file.
  [[maybe_unused]] const int emptied = ::ftruncate(lock_.get(), 0);
}

void OutputFolder::write(std::string_view name, std::string_view text) const {
  const std::filesystem::path relative(name);
  const auto target = path_ / relative;
  std::error_code error;
  auto folder = path_;  // the folder itself may be a link
  for (const auto& part : relative) {
    const bool link = folder != path_ && std::filesystem::is_symlink(folder, error);
    if (part == ".." || part.is_absolute() || link)
      throw FileError(fmt::format("{} would leave the output folder", name));
    folder /= part;
  }
  std::filesystem::create_directories(target.parent_path(), error);
  if (error)
    throw FileError(
        fmt::format("cannot make folder {}: {}", target.parent_path().string(), error.message()));
  const auto temporary = temporary_of(target);
  OpenFile file(create(temporary));
  try {
    if (name.ends_with(".gz"))
      write_all(file.get(), gzip_of(text), temporary);
    else
      write_all(file.get(), text, temporary);
    if (::fsync(file.get()) != 0 && errno != EINVAL) fail("cannot write", temporary);
    if (!file.close()) fail("cannot write", temporary);
    replace(target);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

}  // namespace odeum::record
