// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "odeum/record/output_folder.hpp"
#include "odeum/shards/plan_file.hpp"
#include "odeum/studies/packing.hpp"

/// What plan, shard and merge do: each runs the planned command with an assignment, which says what
/// this process does of it.
namespace odeum::shards {

/// Runs the planned command with the caller's assignment; its exit code.
using Command = std::function<int(const std::vector<std::string>& words)>;

/// Refuses a folder that has shards of a plan; what is compiled for the plan is kept in it.
void prepare(const record::OutputFolder& folder);

/// The shards of a plan and the files that are written for it.
struct MadePlan {
  PlanFile file;
  double seconds = 0, longest = 0;  ///< foreseen: of all tasks, of the longest shard
};
/// Packs the tasks in about `shards` shards, or in as many that each takes about `shard_seconds`
/// where that is above zero. `plan` has words, program and content.
MadePlan make_plan(const record::OutputFolder& folder, PlanFile plan,
                   const study::PlannedTasks& foreseen, double shards, double shard_seconds);

/// Throws PlanError for the plan of another program.
void require_same_program(const PlanFile& plan, const std::string& program);

/// Why a shard is to be run: it was not, or it is damaged, which `fault` says.
enum class Done { no, yes, damaged };
Done done(const std::filesystem::path& run, const PlanFile& plan, std::uint64_t shard,
          std::string& fault);
/// Runs a shard that is not done. `assignment` is the one that the command works by; `accepted`
/// tells the exit codes with which a shard is done. Its files get their final name at the end.
/// Throws record::FileError, PlanError and Interrupted.
int run_shard(Assignment& assignment, const PlanFile& plan, std::uint64_t shard,
              const Command& command, const std::function<bool(int code)>& accepted);

/// The missing shards, which are looked for again where a file system shows names late.
MissingShards await_shards(const std::filesystem::path& run, const PlanFile& plan);
/// Runs the command with the results of all shards, which writes to `out`.
int merge(Assignment& assignment, const PlanFile& plan, const std::filesystem::path& out,
          const Command& command);

}  // namespace odeum::shards
