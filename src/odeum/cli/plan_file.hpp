// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

/// The file of a plan, and what is there of its shards.
namespace odeum::cli {

struct PlanFile {
  std::string id, program, content, folder;
  std::vector<std::string> words;
  std::uint64_t shards = 0, first_alone = 0;
  std::vector<std::uint32_t> shares;  ///< by task, its shard
};

std::string sum_of(const std::string& text);
/// Fingerprint of this program and its plug-ins.
std::string program_sum();

/// Throws UsageError for a folder without a sound plan.
PlanFile read_plan(const std::string& run);
/// Throws UsageError for the plan of another program.
void require_same_program(const PlanFile& plan);

/// The files of a shard with their sums; a name that another process has removed is skipped.
nlohmann::ordered_json sums_of(const std::filesystem::path& folder);
/// What is wrong with a finished shard; empty: nothing.
std::string fault_of(const PlanFile& plan, const std::filesystem::path& folder);
/// The shards that are not there, or damaged, each with the reason.
std::vector<std::pair<std::uint64_t, std::string>> missing_of(const PlanFile& plan,
                                                              const std::filesystem::path& run);

}  // namespace odeum::cli
