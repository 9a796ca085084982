// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "odeum/record/store.hpp"
#include "odeum/studies/runner.hpp"

/// The work of a command in shards: `odeum plan` counts its tasks, `odeum shard` does those of one
/// shard and keeps their results, and `odeum merge` runs the command with all results there.
namespace odeum::cli {

enum class Role { alone, plan, shard, merge };

/// What this process does of the command that it runs.
struct Part {
  Role role = Role::alone;
  std::filesystem::path run;                   ///< the folder of the plan
  std::string mark;                            ///< of the plan, by which results are kept
  study::Share share;                          ///< of a shard
  std::string content;                         ///< of the files that the command loaded
  std::vector<std::filesystem::path> results;  ///< folders of the shards' results, for a merge
  std::filesystem::path out;                   ///< of a merge
};
Part& part();

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

/// The store of this process's part: the shard's own; in a merge that of all shards.
std::unique_ptr<record::Store> store_of_part();

/// Throws FileError where a shard's results could not be kept.
void require_kept(const record::Store* store);

/// The folder to which this process writes: that of the command, or of the merge; empty: to none.
std::string output_of_part(const std::string& given);

/// Notes in a plan, and compares elsewhere, what the command loaded. Throws UsageError where a
/// file has changed since.
void require_same_content(const std::string& content);

}  // namespace odeum::cli
