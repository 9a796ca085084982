// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "odeum/studies/runner.hpp"

namespace odeum::study {

/// Tasks in shards: first those of tasks that may run beside others, then those of timed tasks,
/// each the longest first.
struct Packing {
  std::vector<std::uint32_t> shares;  ///< by task, its shard
  std::vector<double> seconds;        ///< by shard, foreseen
  std::uint64_t first_alone = 0;      ///< the first shard of timed tasks
};

/// Packs tasks in about `shards` shards, none empty: the longest first, each to the shard that
/// has the least.
Packing pack(const PlannedTasks& foreseen, double shards);

/// The shares of tasks as text, by which a plan keeps them, and back.
std::string text_of_shares(const std::vector<std::uint32_t>& shares);
std::vector<std::uint32_t> shares_of(const std::string& text);

}  // namespace odeum::study
