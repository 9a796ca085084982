// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/shards/plan_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "odeum/core/checksum.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/input/yaml_tree.hpp"
#include "odeum/studies/packing.hpp"

namespace odeum::shards {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t most_bytes = 256'000'000;

std::string sum_of(const std::string& text) { return fmt::format("{:016x}", checksum(text)); }

ordered_json content_of(const PlanFile& plan) {
  return {{"program", plan.program},
          {"content", plan.content},
          {"folder", plan.folder},
          {"words", plan.words},
          {"shards", plan.shards},
          {"first_alone", plan.first_alone},
          {"foreseen_seconds", plan.foreseen_seconds},
          {"shard_of_task", study::text_of_shares(plan.shares)}};
}

std::string id_of(const PlanFile& plan) { return sum_of(content_of(plan).dump()); }

/// A whole number that is at most `most`: nothing for another value.
std::optional<std::uint64_t> count_in(const json& at, const char* key, std::uint64_t most) {
  const json& value = at.at(key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most) return std::nullopt;
  return value.get<std::uint64_t>();
}

/// What the numbers of a plan contradict in one another; empty: nothing.
std::string fault_of(const PlanFile& plan, const std::string& shard_of_task) {
  if (plan.foreseen_seconds.size() != plan.shards)
    return fmt::format("foreseen_seconds has {} numbers for {} shards",
                       plan.foreseen_seconds.size(), plan.shards);
  std::vector<bool> has_tasks(plan.shards, false);
  for (const std::uint32_t shard : plan.shares) {
    if (shard >= plan.shards) return "shard_of_task names a shard that is beyond the last";
    has_tasks[shard] = true;
  }
  if (study::text_of_shares(plan.shares) != shard_of_task)
    return "shard_of_task holds other things than numbers of shards";
  if (std::ranges::find(has_tasks, false) != has_tasks.end()) return "a shard has no task";
  return id_of(plan) == plan.id ? "" : "what it says is not what a plan wrote: its id differs";
}

PlanFile plan_in(const json& file, std::string& fault) {
  PlanFile plan{.id = file.at("id"),
                .program = file.at("program"),
                .content = file.at("content"),
                .folder = file.at("folder"),
                .words = file.at("words"),
                .foreseen_seconds = file.at("foreseen_seconds")};
  const auto shards = count_in(file, "shards", most_shards);
  const auto first_alone = count_in(file, "first_alone", most_shards);
  if (!shards || *shards == 0 || !first_alone) {
    fault = fmt::format("shards and first_alone: got {} and {}, expected whole numbers up to {}",
                        file.at("shards").dump(), file.at("first_alone").dump(), most_shards);
    return plan;
  }
  plan.shards = *shards;
  plan.first_alone = *first_alone;
  const std::string shard_of_task = file.at("shard_of_task");
  plan.shares = study::shares_of(shard_of_task);
  fault = fault_of(plan, shard_of_task);
  return plan;
}

/// Where a file's content is not what was written of it.
std::string fault_of_file(const fs::path& file, const std::string& name, const json& written) {
  std::error_code absent;
  const bool regular = fs::is_regular_file(fs::symlink_status(file, absent));
  if (!regular || absent) return "lacks " + name;
  if (fs::file_size(file, absent) != written.at("bytes").get<std::uintmax_t>() || absent)
    return name + " is damaged";
  const std::optional<std::string> content = text_of_file(file);
  if (!content) return "lacks " + name;
  return written.at("sum") == sum_of(*content) ? "" : name + " is damaged";
}

std::string fault_in_files(const json& files, const fs::path& results) {
  for (const auto& [name, written] : files.items()) {
    if (name.find('/') != std::string::npos) return "names a file outside of its folder";
    if (std::string fault = fault_of_file(results / name, name, written); !fault.empty())
      return fault;
    if (interrupted) throw Interrupted();
  }
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(results, failed))
    if (const std::string name = entry.path().filename().string();
        name.ends_with(record::Store::extension) && !files.contains(name))
      return name + " is not a file that the shard wrote";
  return failed ? "has no results" : "";
}

}  // namespace

std::string text_of(PlanFile& plan) {
  plan.id = id_of(plan);
  ordered_json all{{"id", plan.id}};
  all.update(content_of(plan));
  return all.dump(2) + "\n";
}

PlanFile read_plan(const fs::path& run) {
  const fs::path file = run / "plan.json";
  std::error_code absent;
  if (!fs::exists(fs::symlink_status(file, absent)))
    throw PlanError(run.string() + " has no plan.json; odeum plan makes one");
  try {
    std::string fault;
    PlanFile plan =
        plan_in(json::parse(read_text_file(file.string(), "the plan", most_bytes)), fault);
    if (!fault.empty())
      throw PlanError(fmt::format("{} is damaged: {}; plan anew", file.string(), fault));
    return plan;
  } catch (const json::exception& error) {
    throw PlanError(
        fmt::format("{} is damaged, or not a plan: {}; plan anew", file.string(), error.what()));
  } catch (const InputError& error) {
    throw PlanError(error.what());
  }
}

std::string text_of_shard(const PlanFile& plan, std::uint64_t shard, const fs::path& folder,
                          double seconds) {
  ordered_json files = ordered_json::object();
  for (const auto& entry : fs::directory_iterator(folder / "results"))
    if (const auto text = text_of_file(entry.path()))
      files[entry.path().filename().string()] = {{"bytes", text->size()}, {"sum", sum_of(*text)}};
  const ordered_json all{{"plan", plan.id},
                         {"shard", shard},
                         {"processor", cpu_model()},
                         {"seconds", seconds},
                         {"files", files}};
  return all.dump(2) + "\n";
}

std::string fault_of(const PlanFile& plan, std::uint64_t shard, const fs::path& folder) {
  const auto text = text_of_file(folder / "shard.json");
  if (!text) return "has no shard.json";
  try {
    const json said = json::parse(*text);
    if (said.at("plan") != plan.id) return "is of another plan";
    if (said.at("shard") != shard) return "has the results of another shard";
    return fault_in_files(said.at("files"), folder / "results");
  } catch (const json::exception& error) {
    return error.what();
  }
}

MissingShards missing_of(const PlanFile& plan, const fs::path& run) {
  MissingShards missing;
  // A network file system asks its server for new names when a folder is read.
  std::error_code failed;
  [[maybe_unused]] const fs::directory_iterator look(run / "shards", failed);
  for (std::uint64_t shard = 0; shard < plan.shards; ++shard) {
    if (interrupted) throw Interrupted();
    const fs::path done = shard_folder(run, shard, true);
    if (!fs::exists(done, failed))
      missing.emplace_back(
          shard, fs::exists(shard_folder(run, shard, false), failed) ? unfinished : "was not run");
    else if (const std::string fault = fault_of(plan, shard, done); !fault.empty())
      missing.emplace_back(shard, fault);
  }
  return missing;
}

}  // namespace odeum::shards
