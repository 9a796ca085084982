// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// The scripts with which shards are handed to Slurm as job arrays.
namespace odeum::shards {

/// A task of an array: `run` is the folder of the plan. More `#SBATCH` lines may be added to it.
std::string shard_script(const std::filesystem::path& run);
/// Submits shards 0 to `shards` - 1, in arrays that are as long as the site's MaxArraySize allows;
/// those from `first_alone` on have a node to themselves each.
std::string submit_script(std::uint64_t shards, std::uint64_t first_alone);
/// Submits just these shards, in ascending order.
std::string resubmit_script(const std::vector<std::uint64_t>& shards, std::uint64_t first_alone);

}  // namespace odeum::shards
