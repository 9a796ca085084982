// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "odeum/shards/assignment.hpp"

/// The file of a plan, and what is there of its shards.
namespace odeum::shards {

inline constexpr std::uint64_t most_shards = 1'000'000;

struct PlanFile {
  std::string id = {};       ///< a checksum of all else
  std::string program = {};  ///< a fingerprint of the program that made the plan, with its plug-ins
  std::string content = {};  ///< tells the files that were loaded for the plan from others
  std::string folder = {};   ///< in which the command was planned
  std::vector<std::string> words = {};
  std::uint64_t shards = 0, first_alone = 0;
  std::vector<double> foreseen_seconds = {};  ///< by shard
  std::vector<std::uint32_t> shares = {};     ///< by task, its shard
};

/// The text of plan.json; sets the id.
std::string text_of(PlanFile& plan);
/// Throws PlanError for a folder whose plan.json is not a file of at most 256 MB that a plan wrote,
/// with the checksum of all that it says.
PlanFile read_plan(const std::filesystem::path& run);

/// The text of shard.json, with the sums of the files in the shard's results: a name that another
/// process has removed is skipped.
std::string text_of_shard(const PlanFile& plan, std::uint64_t shard,
                          const std::filesystem::path& folder, double seconds);
/// What is wrong with a finished shard; empty: nothing.
std::string fault_of(const PlanFile& plan, std::uint64_t shard,
                     const std::filesystem::path& folder);

using MissingShards = std::vector<std::pair<std::uint64_t, std::string>>;
inline constexpr const char* unfinished = "is unfinished";
/// The shards that are not there, or damaged, each with the reason. Throws Interrupted.
MissingShards missing_of(const PlanFile& plan, const std::filesystem::path& run);

}  // namespace odeum::shards
