// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "odeum/record/store.hpp"
#include "odeum/studies/runner.hpp"

/// The work of a command in shards: `odeum plan` counts its tasks, `odeum shard` does those of one
/// shard and keeps their results, and `odeum merge` runs the command with all results there.
namespace odeum::cli {

enum class Role { alone, plan, shard, merge };

/// One command line while it runs: what was loaded for it, and what this process does of it where
/// it is that of a plan. Not thread-safe.
struct Session {
  std::string content;                       ///< tells the files that were loaded from others
  std::map<std::string, std::string> words;  ///< by case of these files, those that name it

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

/// What a plan compiles and computes of its texts is kept in its folder.
void keep_code_in(const std::filesystem::path& run);

/// A shard's copy of that on a disk of its own machine, in $TMPDIR: a new folder, which nobody
/// can have prepared and which goes with this object. Code in a plan's folder that others could
/// have written is not taken; the shard then compiles its own.
class ShardCache {
 public:
  explicit ShardCache(const std::filesystem::path& run);
  ~ShardCache();
  ShardCache(const ShardCache&) = delete;
  ShardCache& operator=(const ShardCache&) = delete;

 private:
  std::string folder_;
};

/// Has the system write a file or a folder to the disk. Throws FileError.
void sync(const std::filesystem::path& path);

/// The store of a plan's part: the shard's own; in a merge that of all shards. Null for the plan.
std::unique_ptr<record::Store> store_of_part(const Session& session);

/// Throws FileError where a shard's results could not be kept.
void require_kept(const Session& session, const record::Store* store);

/// Throws UsageError where a file has changed since the plan was made.
void require_planned_content(const Session& session);

}  // namespace odeum::cli
