// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/shards/shards.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>

#include "odeum/core/clocks.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/shards/job_scripts.hpp"

namespace odeum::shards {
namespace {

namespace fs = std::filesystem;

/// A shard's copy of what the plan compiled and computed, on a disk of its own machine: a new
/// folder, which nobody can have prepared and which goes with this object. Code in a plan's folder
/// that others could have written is not taken; the shard then compiles its own.
class ShardCache {
 public:
  explicit ShardCache(const fs::path& run) {
    std::error_code failed;
    std::string name = (fs::temp_directory_path(failed) / "odeum-shard-XXXXXX").string();
    if (failed || !::mkdtemp(name.data())) return;
    folder_ = name;
    formula::keep_cache_in(folder_);
    const fs::path own = formula::cache_folder(),
                   planned = fs::canonical(run / "code/odeum", failed);
    if (own.empty() || failed || !formula::why_not_private(planned).empty()) return;
    for (const auto& entry : fs::directory_iterator(planned, failed)) {
      std::error_code there;
      if (entry.is_regular_file(there))
        fs::copy_file(entry.path(), own / entry.path().filename(), there);
    }
  }
  ~ShardCache() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  ShardCache(const ShardCache&) = delete;
  ShardCache& operator=(const ShardCache&) = delete;

 private:
  std::string folder_;
};

/// Has the system write a file or a folder to the disk. Throws FileError.
void sync(const fs::path& path) {
  const record::OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  // Some file systems sync no folders.
  if (file.get() < 0 || (::fsync(file.get()) != 0 && errno != EINVAL))
    throw record::FileError(
        fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
}

/// The command in the folder in which it was planned, to which the names of its files belong.
int run_planned(const PlanFile& plan, const Command& command) {
  std::error_code error;
  fs::current_path(plan.folder, error);
  if (error)
    throw PlanError(fmt::format("the plan was made in {}, which cannot be entered: {}", plan.folder,
                                error.message()));
  return command(plan.words);
}

void take(Assignment& assignment, Role role, const fs::path& run, const PlanFile& plan) {
  assignment.role = role;
  assignment.run = run;
  assignment.plan = "plan " + plan.id;
  assignment.planned_content = plan.content;
}

}  // namespace

void prepare(const record::OutputFolder& folder) {
  const fs::path shards = folder.path() / "shards";
  if (fs::exists(folder.path() / "plan.json") && fs::exists(shards) && !fs::is_empty(shards))
    throw PlanError(fmt::format("--out {}: has shards of a plan already; expected a new folder",
                                folder.path().string()));
  formula::keep_cache_in(fs::absolute(folder.path()) / "code");
}

MadePlan make_plan(const record::OutputFolder& folder, PlanFile plan,
                   const study::PlannedTasks& foreseen, double shards, double shard_seconds) {
  const double all = std::accumulate(foreseen.seconds.begin(), foreseen.seconds.end(), 0.);
  const double wanted = shard_seconds > 0 ? all / shard_seconds : shards;
  study::Packing packing = study::pack(foreseen, std::min<double>(wanted, most_shards));
  plan.folder = fs::current_path().string();
  plan.shards = packing.seconds.size();
  plan.first_alone = packing.first_alone;
  plan.foreseen_seconds = std::move(packing.seconds);
  plan.shares = std::move(packing.shares);
  fs::create_directories(folder.path() / "shards");
  fs::create_directories(folder.path() / "logs");
  try {
    folder.write("plan.json", text_of(plan));
  } catch (const nlohmann::json::exception&) {
    throw PlanError("a word of the command, or the folder's name, is not UTF-8 text");
  }
  folder.write("shard.sh", shard_script(fs::absolute(folder.path())));
  folder.write("submit.sh", submit_script(plan.shards, plan.first_alone));
  const double longest = *std::ranges::max_element(plan.foreseen_seconds);
  return {std::move(plan), all, longest};
}

void require_same_program(const PlanFile& plan, const std::string& program) {
  if (plan.program != program)
    throw PlanError(
        "the plan was made by another build of odeum; make the plan anew with this one");
}

Done done(const fs::path& run, const PlanFile& plan, std::uint64_t shard, std::string& fault) {
  const fs::path folder = shard_folder(run, shard, true);
  if (!fs::exists(folder)) return Done::no;
  fault = fault_of(plan, shard, folder);
  return fault.empty() ? Done::yes : Done::damaged;
}

int run_shard(Assignment& assignment, const PlanFile& plan, std::uint64_t shard,
              const Command& command, const std::function<bool(int code)>& accepted) {
  const fs::path run = assignment.run, done = shard_folder(run, shard, true),
                 doing = shard_folder(run, shard, false);
  fs::remove_all(done);
  take(assignment, Role::shard, run, plan);
  assignment.share.at = shard;
  assignment.share.shares = std::make_shared<const std::vector<std::uint32_t>>(plan.shares);
  assignment.share.begun = std::make_shared<std::uint64_t>(0);
  const ShardCache cache(run);
  const auto start = std::chrono::steady_clock::now();
  const record::OutputFolder folder(doing);
  fs::create_directories(doing / "results");
  if (const int code = run_planned(plan, command); !accepted(code)) return code;
  if (interrupted) throw Interrupted();
  const std::string said = text_of_shard(plan, shard, doing, seconds_since(start));
  for (const auto& entry : fs::directory_iterator(doing / "results")) sync(entry.path());
  folder.write("shard.json", said);
  fs::rename(doing, done);
  sync(done.parent_path());
  return 0;
}

MissingShards await_shards(const fs::path& run, const PlanFile& plan) {
  MissingShards missing = missing_of(plan, run);
  // A network file system may show names and content some time after another machine made them.
  constexpr int looks = 2;
  for (int look = 0; look < looks && !missing.empty() && !interrupted; ++look) {
    std::this_thread::sleep_for(std::chrono::milliseconds(400 << look));
    missing = missing_of(plan, run);
  }
  return missing;
}

int merge(Assignment& assignment, const PlanFile& plan, const fs::path& out,
          const Command& command) {
  const fs::path run = assignment.run;
  take(assignment, Role::merge, run, plan);
  assignment.share.all_kept = true;
  assignment.out = out;
  for (std::uint64_t shard = 0; shard < plan.shards; ++shard)
    assignment.results.push_back(shard_folder(run, shard, true) / "results");
  const int code = run_planned(plan, command);
  fs::remove_all(run / "merge");  // the store of a merge has no results of its own
  return code;
}

}  // namespace odeum::shards
