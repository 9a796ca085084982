// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/cache.hpp"

#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "odeum/input/text_file.hpp"

namespace odeum::formula {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view unfinished = "work-";

fs::path& given_base() {
  static fs::path base;
  return base;
}

std::string host() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  return content_key(name).substr(0, 8);
}

/// Whether no process works on it any more. Those of other machines, which may share the folder,
/// are told by their age: no run works on one for a day.
bool abandoned(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  const std::string here = std::string(unfinished) + host() + '-';
  pid_t process = 0;
  if (name.starts_with(here)) {
    std::from_chars(name.data() + here.size(), name.data() + name.size(), process);
    if (process > 0) return ::kill(process, 0) != 0 && errno == ESRCH;
  }
  std::error_code gone;
  const auto written = entry.last_write_time(gone);
  return !gone && fs::file_time_type::clock::now() - written > std::chrono::hours(24);
}

bool sweep(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const fs::path& path = entry.path();
    if ((path.filename().string().starts_with(unfinished) || path.extension() == ".part") &&
        abandoned(entry))
      fs::remove_all(path, ignored);
  }
  return true;
}

std::string sealed(const std::string& name, const std::string& text) {
  return text + content_key(name + '\n' + text) + '\n';
}

/// The group to which nobody but this user belongs: the one of their name that many systems give
/// to each user. Nothing where there is none.
std::optional<gid_t> own_group() {
  const passwd* const user = ::getpwuid(::geteuid());
  if (!user) return std::nullopt;
  const std::string name = user->pw_name;
  const gid_t id = user->pw_gid;
  const group* const members = ::getgrgid(id);
  if (!members || name != members->gr_name) return std::nullopt;
  for (char** each = members->gr_mem; *each; ++each)
    if (name != *each) return std::nullopt;
  return id;
}

/// Whether another user may put entries into a folder, or in place of its own.
bool others_write(const struct stat& status) {
  static const std::optional<gid_t> own = own_group();  // once: the look-up is not thread-safe
  return (status.st_mode & S_IWOTH) != 0 ||
         ((status.st_mode & S_IWGRP) != 0 && own != status.st_gid);
}

}  // namespace

std::string why_not_private(const fs::path& folder) {
  struct stat status {};
  if (::lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    return folder.string() + " is not a folder";
  if (status.st_uid != ::geteuid()) return folder.string() + " belongs to another user";
  if (others_write(status)) return "others may write in " + folder.string();
  for (fs::path above = folder.parent_path();; above = above.parent_path()) {
    if (::lstat(above.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
      return above.string() + " is not a folder";
    if (status.st_uid != ::geteuid() && status.st_uid != 0)
      return above.string() + " belongs to another user, who could replace " + folder.string();
    // In a folder with the sticky bit, as /tmp, entries are replaced by their owners alone.
    if (others_write(status) && (status.st_mode & S_ISVTX) == 0)
      return fmt::format("others may write in {} and could replace {}", above.string(),
                         folder.string());
    if (above == above.root_path()) return "";
  }
}

std::string content_key(const std::string& text) {
  std::uint64_t a = 0xcbf29ce484222325U, b = 0x84222325cbf29ce4U;  // FNV-1a, twice
  for (const char c : text) {
    a = (a ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    b = (b ^ static_cast<unsigned char>(c) ^ (a >> 40)) * 0x100000001b3U;
  }
  return fmt::format("{:016x}{:016x}", a, b);
}

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

CacheFolder find_cache_folder() {
  fs::path base = given_base().empty() ? fs::path(environment("XDG_CACHE_HOME")) : given_base();
  if (base.empty() && !environment("HOME").empty()) base = environment("HOME") + "/.cache";
  if (!base.is_absolute()) return {"", "neither $XDG_CACHE_HOME nor $HOME is an absolute path"};
  std::error_code failed;
  fs::create_directories(base, failed);
  // Links are resolved once: what is checked is what is used.
  const fs::path real = fs::canonical(base, failed);
  if (failed) return {"", fmt::format("{}: {}", base.string(), failed.message())};
  const fs::path folder = real / "odeum";
  ::mkdir(folder.c_str(), 0700);
  if (std::string why = why_not_private(folder); !why.empty()) return {"", std::move(why)};
  if (::chmod(folder.c_str(), 0700) != 0) return {"", folder.string() + " cannot be closed"};
  return {folder.string(), ""};
}

void keep_cache_in(const fs::path& base) { given_base() = base; }

std::string cache_folder() { return find_cache_folder().path; }

std::string unfinished_in(const fs::path& folder) {
  return (folder / fmt::format("{}{}-{}-XXXXXX", unfinished, host(), ::getpid())).string();
}

void keep_text(const std::string& name, const std::string& text) {
  const std::string folder = cache_folder();
  if (folder.empty()) return;
  // Here and not in cache_folder(): a run that only reads would wait for the list of thousands of
  // files.
  [[maybe_unused]] static const bool swept = sweep(folder);
  std::string part = unfinished_in(folder);
  const int file = ::mkstemp(part.data());
  if (file < 0) return;
  ::close(file);
  if (!write_text(part, sealed(name, text)) ||
      ::rename(part.c_str(), (fs::path(folder) / name).c_str()) != 0)
    ::unlink(part.c_str());
}

std::optional<std::string> kept_text(const std::string& name) {
  const std::string folder = cache_folder();
  if (folder.empty()) return std::nullopt;
  std::optional<std::string> all = text_of_file(fs::path(folder) / name);
  constexpr std::size_t seal = 33;  // the hash and its line's end
  if (!all || all->size() < seal) return std::nullopt;
  const std::string text = all->substr(0, all->size() - seal);
  if (*all != sealed(name, text)) return std::nullopt;
  return text;
}

}  // namespace odeum::formula
