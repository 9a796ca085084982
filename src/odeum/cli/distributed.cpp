// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/distributed.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "odeum/cli/session.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::cli {

constexpr const char* cache_variable = "XDG_CACHE_HOME";  // of formula::cache_folder

std::filesystem::path shard_folder(const std::filesystem::path& run, std::uint64_t shard,
                                   bool done) {
  return run / "shards" / fmt::format("{}{}", shard, done ? "" : ".part");
}

void keep_code_in(const std::filesystem::path& run) {
  ::setenv(cache_variable, (std::filesystem::absolute(run) / "code").c_str(), 1);
}

ShardCache::ShardCache(const std::filesystem::path& run) {
  namespace fs = std::filesystem;
  std::error_code failed;
  std::string name = (fs::temp_directory_path(failed) / "odeum-shard-XXXXXX").string();
  if (failed || !::mkdtemp(name.data())) return;
  folder_ = name;
  ::setenv(cache_variable, folder_.c_str(), 1);
  const fs::path own = formula::cache_folder(), planned = fs::canonical(run / "code/odeum", failed);
  if (own.empty() || failed || !formula::why_not_private(planned).empty()) return;
  for (const auto& entry : fs::directory_iterator(planned, failed)) {
    std::error_code there;
    if (entry.is_regular_file(there))
      fs::copy_file(entry.path(), own / entry.path().filename(), there);
  }
}

ShardCache::~ShardCache() {
  std::error_code ignored;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
}

void sync(const std::filesystem::path& path) {
  const record::OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  // Some file systems sync no folders.
  if (file.get() < 0 || (::fsync(file.get()) != 0 && errno != EINVAL))
    throw record::FileError(
        fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
}

std::string Session::output(const std::string& given) const {
  return is_alone() ? given : role == Role::merge ? out.string() : "";
}

std::unique_ptr<record::Store> store_of_part(const Session& session) {
  if (session.role == Role::plan) return nullptr;
  constexpr auto no_limit = static_cast<std::uintmax_t>(-1);
  const std::filesystem::path own = session.role == Role::shard
                                        ? shard_folder(session.run, session.share.at, false)
                                        : session.run / "merge";
  auto store = std::make_unique<record::Store>(own / "results", no_limit);
  for (const std::filesystem::path& folder : session.results) store->read_also(folder);
  if (!store->problem().empty()) throw record::FileError(store->problem());
  return store;
}

void require_kept(const Session& session, const record::Store* store) {
  if (session.role == Role::shard && !store->problem().empty())
    throw record::FileError("the shard's results could not be kept: " + store->problem());
}

void require_planned_content(const Session& session) {
  const bool planned = session.role == Role::shard || session.role == Role::merge;
  if (!planned || session.planned_content == session.content) return;
  throw UsageError("a problem's file has changed since the plan was made; plan anew");
}

}  // namespace odeum::cli
