// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/shards/job_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "odeum/core/shell_word.hpp"

namespace odeum::shards {
namespace {

// An index of an array is below MaxArraySize: tasks get the offset of theirs. A refused sbatch ends
// the script.
constexpr const char* head = R"sh(#!/bin/sh
set -eu
cd "$(dirname "$0")"
most=$(scontrol show config | sed -n 's/^MaxArraySize *= *\([0-9]*\).*/\1/p')
if [ -z "$most" ]; then echo "scontrol does not tell MaxArraySize" >&2; exit 1; fi
how=
submit() {
  sbatch $how --array="$1" --export=ALL,ODEUM_FIRST="$2" --output=logs/%A_%a.log shard.sh
}
)sh";

// Shards that are timed have a node to themselves, and keep the processor that they begin on.
constexpr const char* with_own_node = "--exclusive";

}  // namespace

std::string shard_script(const std::filesystem::path& run) {
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return fmt::format(R"sh(#!/bin/sh
#SBATCH --job-name=odeum
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
exec {} shard {} $((ODEUM_FIRST + SLURM_ARRAY_TASK_ID))
)sh",
                     shell_word(program.string()), shell_word(run.string()));
}

std::string submit_script(std::uint64_t shards, std::uint64_t first_alone) {
  std::string text = fmt::format(R"sh({}range() {{
  first=$1
  while [ "$first" -lt "$2" ]; do
    count=$(($2 - first))
    if [ "$count" -gt "$most" ]; then count=$most; fi
    submit "0-$((count - 1))" "$first"
    first=$((first + count))
  done
}}
)sh",
                                 head);
  if (first_alone > 0) text += fmt::format("range 0 {}\n", first_alone);
  if (first_alone < shards)
    text += fmt::format("how={}\nrange {} {}\n", with_own_node, first_alone, shards);
  return text;
}

std::string resubmit_script(const std::vector<std::uint64_t>& shards, std::uint64_t first_alone) {
  std::string text = fmt::format(R"sh({}these() {{
  indices=
  first=
  for shard; do
    if [ -n "$first" ] && [ "$((shard - first))" -ge "$most" ]; then
      submit "$indices" "$first"
      first=
    fi
    if [ -z "$first" ]; then
      first=$shard
      indices=0
    else
      indices=$indices,$((shard - first))
    fi
  done
  submit "$indices" "$first"
}}
)sh",
                                 head);
  const auto alone_from = std::ranges::lower_bound(shards, first_alone);
  if (alone_from != shards.begin())
    text += fmt::format("these {}\n", fmt::join(shards.begin(), alone_from, " "));
  if (alone_from != shards.end())
    text +=
        fmt::format("how={}\nthese {}\n", with_own_node, fmt::join(alone_from, shards.end(), " "));
  return text;
}

}  // namespace odeum::shards
