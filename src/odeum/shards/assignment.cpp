// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/shards/assignment.hpp"

#include <fmt/format.h>

#include "odeum/record/output_folder.hpp"

namespace odeum::shards {

std::filesystem::path shard_folder(const std::filesystem::path& run, std::uint64_t shard,
                                   bool done) {
  return run / "shards" / fmt::format("{}{}", shard, done ? "" : ".part");
}

std::string Assignment::output(const std::string& given) const {
  return is_alone() ? given : role == Role::merge ? out.string() : "";
}

std::unique_ptr<record::Store> store_of(const Assignment& assignment) {
  if (assignment.role == Role::plan) return nullptr;
  constexpr auto no_limit = static_cast<std::uintmax_t>(-1);
  const std::filesystem::path own = assignment.role == Role::shard
                                        ? shard_folder(assignment.run, assignment.share.at, false)
                                        : assignment.run / "merge";
  auto store = std::make_unique<record::Store>(own / "results", no_limit);
  for (const std::filesystem::path& folder : assignment.results) store->read_also(folder);
  if (!store->problem().empty()) throw record::FileError(store->problem());
  return store;
}

void require_kept(const Assignment& assignment, const record::Store* store) {
  if (assignment.role == Role::shard && !store->problem().empty())
    throw record::FileError("the shard's results could not be kept: " + store->problem());
}

void require_planned_content(const Assignment& assignment, const std::string& content) {
  const bool planned = assignment.role == Role::shard || assignment.role == Role::merge;
  if (!planned || assignment.planned_content == content) return;
  throw PlanError("a problem's file has changed since the plan was made; plan anew");
}

}  // namespace odeum::shards
