// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/distributed.hpp"

#include <fmt/format.h>

#include "odeum/cli/session.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::cli {

Part& part() {
  static Part one;
  return one;
}

std::filesystem::path shard_folder(const std::filesystem::path& run, std::uint64_t shard,
                                   bool done) {
  return run / "shards" / fmt::format("{}{}", shard, done ? "" : ".part");
}

std::unique_ptr<record::Store> store_of_part() {
  const Part& here = part();
  if (here.role == Role::plan) return nullptr;
  constexpr auto no_limit = static_cast<std::uintmax_t>(-1);
  const std::filesystem::path own =
      here.role == Role::shard ? shard_folder(here.run, here.share.at, false) : here.run / "merge";
  auto store = std::make_unique<record::Store>(own / "results", no_limit);
  for (const std::filesystem::path& folder : here.results) store->read_also(folder);
  if (!store->problem().empty()) throw record::FileError(store->problem());
  return store;
}

void require_kept(const record::Store* store) {
  if (part().role == Role::shard && !store->problem().empty())
    throw record::FileError("the shard's results could not be kept: " + store->problem());
}

std::string output_of_part(const std::string& given) {
  switch (part().role) {
    case Role::alone:
      return given;
    case Role::merge:
      return part().out.string();
    default:
      return "";
  }
}

void require_same_content(const std::string& content) {
  Part& here = part();
  if (here.role == Role::plan) here.content = content;
  if (here.role == Role::alone || here.content == content) return;
  throw UsageError("a problem's file has changed since the plan was made; plan anew");
}

}  // namespace odeum::cli
