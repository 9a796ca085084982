// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/job_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "odeum/cli/problems.hpp"

namespace odeum::cli {
namespace {

// An index of an array is below MaxArraySize: tasks get the offset of theirs. A refused sbatch ends
// the script.
constexpr const char* head = R"sh(#!/bin/sh
set -eu
cd "$(dirname "$0")"
most=$(scontrol show config | sed -n 's/^MaxArraySize *= *\([0-9]*\).*/\1/p')
if [ -z "$most" ]; then echo "scontrol does not tell MaxArraySize" >&2; exit 1; fi
submit() {
  sbatch --array="$1" --export=ALL,ODEUM_FIRST="$2" --output=logs/%A_%a.log shard.sh
}
)sh";

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

std::string submit_script(std::uint64_t shards) {
  return fmt::format(R"sh({}first=0
while [ "$first" -lt {} ]; do
  count=$(({} - first))
  if [ "$count" -gt "$most" ]; then count=$most; fi
  submit "0-$((count - 1))" "$first"
  first=$((first + count))
done
)sh",
                     head, shards, shards);
}

std::string resubmit_script(const std::vector<std::uint64_t>& shards) {
  return fmt::format(R"sh({}indices=
first=
for shard in {}; do
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
)sh",
                     head, fmt::join(shards, " "));
}

}  // namespace odeum::cli
