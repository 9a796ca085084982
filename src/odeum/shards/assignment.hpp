// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "odeum/record/store.hpp"
#include "odeum/studies/runner.hpp"

/// The work of a command in shards: `odeum plan` counts its tasks, `odeum shard` does those of one
/// shard and keeps their results, and `odeum merge` runs the command with all results there.
namespace odeum::shards {

/// A plan that cannot be used, in a sentence: it is bad input.
class PlanError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Role { alone, plan, shard, merge };

/// What a process does of a command that may be that of a plan. Not thread-safe.
struct Assignment {
  Role role = Role::alone;
  std::filesystem::path run;                   ///< the folder of the plan
  std::string plan;                            ///< the plan's id, by which results are kept
  study::Share share;                          ///< of a shard
  std::string planned_content;                 ///< of the files that were loaded for the plan
  std::vector<std::filesystem::path> results;  ///< folders of the shards' results, for a merge
  std::filesystem::path out;                   ///< of a merge

  bool is_alone() const { return role == Role::alone; }
  /// Nothing is written but results.
  bool is_plan_or_shard() const { return role == Role::plan || role == Role::shard; }
  /// The folder to which the command writes where it is told `given`; empty: to none.
  std::string output(const std::string& given) const;
};

/// The folder of a shard's files, once it is done and before.
std::filesystem::path shard_folder(const std::filesystem::path& run, std::uint64_t shard,
                                   bool done);

/// The store of a plan's part: the shard's own; in a merge that of all shards. Null for the plan.
/// Throws record::FileError.
std::unique_ptr<record::Store> store_of(const Assignment& assignment);

/// Throws record::FileError where a shard's results could not be kept.
void require_kept(const Assignment& assignment, const record::Store* store);

/// Throws PlanError where a file has changed since the plan was made: `content` tells the files
/// that were loaded now from others.
void require_planned_content(const Assignment& assignment, const std::string& content);

}  // namespace odeum::shards
