// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/plan_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "odeum/cli/distributed.hpp"
#include "odeum/cli/kept_results.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/core/checksum.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/studies/packing.hpp"

namespace odeum::cli {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string sum_of(const std::string& text) { return fmt::format("{:016x}", checksum(text)); }
std::string program_sum() { return sum_of(mark_of_program()); }

PlanFile read_plan(const std::string& run) {
  const fs::path file = fs::path(run) / "plan.json";
  const std::optional<std::string> text = text_of_file(file);
  if (!text) throw UsageError("{} has no plan.json; odeum plan makes one", run);
  try {
    const auto json = nlohmann::json::parse(*text);
    const std::string shard_of_task = json.at("shard_of_task");
    PlanFile plan{.id = json.at("id"),
                  .program = json.at("program"),
                  .content = json.at("content"),
                  .folder = json.at("folder"),
                  .words = json.at("words"),
                  .shards = std::max<std::uint64_t>(1, json.at("shards")),
                  .first_alone = json.at("first_alone"),
                  .shares = study::shares_of(shard_of_task)};
    const auto beyond = [&](std::uint32_t shard) { return shard >= plan.shards; };
    if (study::text_of_shares(plan.shares) != shard_of_task ||
        std::ranges::any_of(plan.shares, beyond))
      throw UsageError("{} is damaged: shard_of_task holds other things than numbers of shards",
                       file.string());
    return plan;
  } catch (const nlohmann::json::exception& error) {
    throw UsageError("{} is damaged, or no plan: {}", file.string(), error.what());
  }
}

void require_same_program(const PlanFile& plan) {
  if (plan.program != program_sum())
    throw UsageError(
        "the plan was made by another build of odeum; make the plan anew with this one");
}

ordered_json sums_of(const fs::path& folder) {
  ordered_json sums = ordered_json::object();
  for (const auto& entry : fs::directory_iterator(folder / "results"))
    if (const auto text = text_of_file(entry.path()))
      sums[entry.path().filename().string()] = {{"bytes", text->size()}, {"sum", sum_of(*text)}};
  return sums;
}

std::string fault_of(const PlanFile& plan, const fs::path& folder) {
  const auto text = text_of_file(folder / "shard.json");
  if (!text) return "has no shard.json";
  try {
    const auto json = nlohmann::json::parse(*text);
    if (json.at("plan") != plan.id) return "is of another plan";
    for (const auto& [name, file] : json.at("files").items()) {
      const auto content = text_of_file(folder / "results" / name);
      if (!content) return "lacks " + name;
      if (file.at("bytes") != content->size() || file.at("sum") != sum_of(*content))
        return name + " is damaged";
    }
  } catch (const nlohmann::json::exception& error) {
    return error.what();
  }
  return "";
}

std::vector<std::pair<std::uint64_t, std::string>> missing_of(const PlanFile& plan,
                                                              const fs::path& run) {
  std::vector<std::pair<std::uint64_t, std::string>> missing;
  // A network file system asks its server for new names when a folder is read.
  std::error_code failed;
  [[maybe_unused]] const fs::directory_iterator look(run / "shards", failed);
  for (std::uint64_t shard = 0; shard < plan.shards; ++shard) {
    const fs::path done = shard_folder(run, shard, true);
    if (!fs::exists(done))
      missing.emplace_back(
          shard, fs::exists(shard_folder(run, shard, false)) ? "is unfinished" : "was not run");
    else if (const std::string fault = fault_of(plan, done); !fault.empty())
      missing.emplace_back(shard, fault);
  }
  return missing;
}

}  // namespace odeum::cli
