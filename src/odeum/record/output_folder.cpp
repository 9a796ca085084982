// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

#include "odeum/input/text_file.hpp"
#include "odeum/record/compress.hpp"

namespace odeum::record {
namespace {

/// The file that this thread is writing, until it is whole.
std::string unfinished() {
  static std::atomic<int> threads{0};
  thread_local const int number = threads++;
  return fmt::format(".odeum{}.tmp", number);
}

/// Removes what a killed run was writing.
void sweep(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".odeum") && name.ends_with(".tmp"))
      std::filesystem::remove(entry.path(), ignored);
  }
}

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path) {
  throw FileError(fmt::format("{} {}: {}", what, path.string(), std::strerror(errno)));
}

std::filesystem::path made_folder(std::filesystem::path path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error)
    throw FileError(fmt::format("cannot make folder {}: {}", path.string(), error.message()));
  return path;
}

int create(const std::filesystem::path& path) {
  ::unlink(path.c_str());
  const int file =
      ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (file < 0) fail("cannot create", path);
  return file;
}

}  // namespace

bool OpenFile::close() {
  const int descriptor = std::exchange(descriptor_, -1);
  return descriptor < 0 || ::close(descriptor) == 0;
}

bool write_all(const OpenFile& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.get(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

OutputFolder::OutputFolder(std::filesystem::path path)
    : path_(made_folder(std::move(path))),
      lock_(::open((path_ / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644)) {
  const auto lock_path = path_ / ".lock";
  if (lock_.get() < 0) fail("cannot open", lock_path);
  // The lock ends with the process; the file's text only names the holder.
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) fail("cannot lock", lock_path);
    const std::string holder = text_of_file(lock_path).value_or("");
    throw FileError(fmt::format("folder {} is in use by {}", path_.string(),
                                holder.empty() ? "another run" : holder));
  }
  char host[256] = "this machine";
  ::gethostname(host, sizeof host - 1);
  const std::string holder = fmt::format("process {} on {}", ::getpid(), host);
  if (::ftruncate(lock_.get(), 0) != 0 || !write_all(lock_, holder))
    fail("cannot write", lock_path);
  sweep(path_);
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
  made_folder(target.parent_path());
  // There is one run per folder, and each of its threads writes one file at a time.
  const auto temporary = path_ / unfinished();
  OpenFile file(create(temporary));
  try {
    // A full disk is reported by the writing, or when the file is synced.
    const bool written =
        name.ends_with(".gz") ? write_all(file, gzip_of(text)) : write_all(file, text);
    if (!written || (::fsync(file.get()) != 0 && errno != EINVAL) || !file.close())
      fail("cannot write", temporary);
    if (::rename(temporary.c_str(), target.c_str()) != 0) fail("cannot write", target);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

}  // namespace odeum::record
