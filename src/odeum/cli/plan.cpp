// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>

#include "odeum/cli/distributed.hpp"
#include "odeum/cli/job_scripts.hpp"
#include "odeum/cli/kept_results.hpp"
#include "odeum/cli/plan_file.hpp"
#include "odeum/cli/problems.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/studies/packing.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::uint64_t most_shards = 1'000'000;

struct PlanOptions {
  std::string run, out, shard_time;
  std::uint64_t shards = 0, shard = 0;
  bool resubmit = false;
};

/// Runs the planned command in the folder in which it was planned.
int run_planned(Session& session, const PlanFile& plan, const RunCommandLine& run) {
  std::error_code error;
  fs::current_path(plan.folder, error);
  if (error)
    throw UsageError("the plan was made in {}, which cannot be entered: {}", plan.folder,
                     error.message());
  return run(plan.words, session);
}

double seconds_of(const std::string& shard_time) {
  return number_of("--shard-time", shard_time,
                   {{"", 1}, {"ms", 1e-3}, {"s", 1}, {"min", 60}, {"h", 3600}});
}

void print_plan(const PlanOptions& options, const study::PlannedTasks& foreseen,
                const study::Packing& packing) {
  const std::size_t shards = packing.seconds.size();
  print("plan    {} tasks in {} shards\n", foreseen.seconds.size(), shards);
  print(
      "time    {:.3g} s foreseen, the longest shard {:.3g} s ({} tasks timed, {} of earlier "
      "runs)\n",
      std::accumulate(packing.seconds.begin(), packing.seconds.end(), 0.),
      *std::ranges::max_element(packing.seconds), foreseen.timed, foreseen.earlier);
  if (shards < options.shards)
    print("note    fewer than {} shards, since a task is not split\n", options.shards);
  print(
      "slurm   sh {0}/submit.sh\nhere    seq 0 {1} | xargs -P {2} -n 1 odeum shard {0}\n"
      "then    odeum merge {0} --out DIR\n",
      shell_word(options.run), shards - 1, packing.first_alone < shards ? 1 : 2);
}

int make_plan(Session& session, const PlanOptions& options, const std::vector<std::string>& words,
              const RunCommandLine& run) {
  if (words.empty())
    throw UsageError("plan: no command; expected one: odeum plan converge --shards 8 --out RUN");
  if ((options.shards == 0) == options.shard_time.empty())
    throw UsageError("plan needs --shards or --shard-time, and not both");
  const double shard_seconds = options.shard_time.empty() ? 0 : seconds_of(options.shard_time);
  const study::Studies studies = study::make_studies();
  if (words.front() != "sweep" && words.front() != "report" &&
      std::ranges::none_of(
          studies, [&](const auto& each) { return each->declaration().name == words.front(); }))
    throw UsageError("plan: {} cannot be done in shards; sweep and the studies can", words.front());
  session.role = Role::plan;
  session.share.plan = std::make_shared<study::PlannedTasks>();
  const record::OutputFolder folder(options.run);
  const fs::path shards_of_it = folder.path() / "shards";
  if (fs::exists(folder.path() / "plan.json") && fs::exists(shards_of_it) &&
      !fs::is_empty(shards_of_it))
    throw UsageError("--out {}: has shards of a plan already; expected a new folder", options.run);
  seconds_of_tasks(session);  // the user's, and not the plan's
  keep_code_in(folder.path());
  if (const int code = run(words, session); code != success) return code;
  const study::PlannedTasks& foreseen = *session.share.plan;
  const std::size_t tasks = foreseen.seconds.size();
  if (tasks == 0)
    throw UsageError("{} has no tasks that shards could do; nothing was planned", words.front());
  const double wanted =
      shard_seconds > 0
          ? std::accumulate(foreseen.seconds.begin(), foreseen.seconds.end(), 0.) / shard_seconds
          : static_cast<double>(options.shards);
  const study::Packing packing = study::pack(foreseen, std::min<double>(wanted, most_shards));
  const std::size_t shards = packing.seconds.size();
  const std::string program = program_sum();
  const std::string shard_of_task = study::text_of_shares(packing.shares);
  const ordered_json json{{"id", sum_of(fmt::format("{} {} {} {}", program, session.content,
                                                    fmt::join(words, "\n"), shard_of_task))},
                          {"program", program},
                          {"content", session.content},
                          {"folder", fs::current_path().string()},
                          {"words", words},
                          {"shards", shards},
                          {"first_alone", packing.first_alone},
                          {"foreseen_seconds", packing.seconds},
                          {"shard_of_task", shard_of_task}};
  fs::create_directories(folder.path() / "shards");
  fs::create_directories(folder.path() / "logs");
  folder.write("plan.json", json.dump(2) + "\n");
  folder.write("shard.sh", shard_script(fs::absolute(folder.path())));
  folder.write("submit.sh", submit_script(shards, packing.first_alone));
  print_plan(options, foreseen, packing);
  return success;
}

int run_shard(Session& here, const PlanOptions& options, const RunCommandLine& run) {
  const PlanFile plan = read_plan(options.run);
  if (options.shard >= plan.shards)
    throw UsageError("shard {}: the plan has shards 0 to {}", options.shard, plan.shards - 1);
  require_same_program(plan);
  here.role = Role::shard;
  here.run = fs::absolute(options.run);
  here.plan = "plan " + plan.id;
  here.planned_content = plan.content;
  here.share.at = options.shard;
  here.share.shares = std::make_shared<const std::vector<std::uint32_t>>(plan.shares);
  here.share.begun = std::make_shared<std::uint64_t>(0);
  const fs::path done = shard_folder(here.run, options.shard, true),
                 doing = shard_folder(here.run, options.shard, false);
  if (fs::exists(done)) {
    const std::string fault = fault_of(plan, done);
    if (fault.empty()) {
      remark("shard {} is there already", options.shard);
      return success;
    }
    remark("shard {} {}; it is run again", options.shard, fault);
    fs::remove_all(done);
  }
  const ShardCache cache(here.run);
  const auto start = std::chrono::steady_clock::now();
  const record::OutputFolder folder(doing);
  fs::create_directories(doing / "results");
  if (const int code = run_planned(here, plan, run); code != success && code != solver_failed)
    return code;
  if (interrupted) throw Stopped("the same command continues");
  const ordered_json json{
      {"plan", plan.id},
      {"shard", options.shard},
      {"processor", cpu_model()},
      {"seconds", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()},
      {"files", sums_of(doing)}};
  for (const auto& entry : fs::directory_iterator(doing / "results")) sync(entry.path());
  folder.write("shard.json", json.dump(2) + "\n");
  fs::rename(doing, done);
  sync(done.parent_path());
  return success;
}

/// A line for each of the first ten, and how many more there are.
std::string text_of(const std::vector<std::pair<std::uint64_t, std::string>>& missing) {
  std::string text;
  constexpr std::size_t most = 10;
  for (std::size_t k = 0; k < std::min(missing.size(), most); ++k)
    text += fmt::format("missing shard {}: {}\n", missing[k].first, missing[k].second);
  if (missing.size() > most) text += fmt::format("        and {} more\n", missing.size() - most);
  return text;
}

int merge(Session& here, const PlanOptions& options, const RunCommandLine& run) {
  const PlanFile plan = read_plan(options.run);
  require_same_program(plan);
  const fs::path folder = fs::absolute(options.run);
  auto missing = missing_of(plan, folder);
  // A network file system may show names and content some time after another machine made them.
  constexpr int looks = 2;
  for (int look = 0; look < looks && !missing.empty() && !interrupted; ++look) {
    std::this_thread::sleep_for(std::chrono::milliseconds(400 << look));
    missing = missing_of(plan, folder);
  }
  if (!missing.empty()) {
    print(text_of(missing));
    if (options.resubmit) {
      std::vector<std::uint64_t> shards;
      for (const auto& [shard, reason] : missing) shards.push_back(shard);
      const record::OutputFolder of_plan(options.run);
      of_plan.write("resubmit.sh", resubmit_script(shards, plan.first_alone));
      print("slurm   sh {}/resubmit.sh\n", shell_word(options.run));
    }
    return check_failed;
  }
  here.role = Role::merge;
  here.run = folder;
  here.plan = "plan " + plan.id;
  here.planned_content = plan.content;
  here.share.all_kept = true;
  here.out = options.out.empty() ? folder / "out" : fs::absolute(options.out);
  for (std::uint64_t shard = 0; shard < plan.shards; ++shard)
    here.results.push_back(shard_folder(folder, shard, true) / "results");
  const int code = run_planned(here, plan, run);
  fs::remove_all(folder / "merge");  // the store of a merge has no results of its own
  return code;
}

int tell_status(const PlanOptions& options) {
  const PlanFile plan = read_plan(options.run);
  const auto missing = missing_of(plan, options.run);
  std::uint64_t unfinished = 0;
  for (const auto& [shard, reason] : missing) unfinished += reason == "is unfinished";
  print("plan    odeum {}\nshards  {} of {} done, {} begun, {} tasks in all\n",
        fmt::join(plan.words, " "), plan.shards - missing.size(), plan.shards, unfinished,
        plan.shares.size());
  print(text_of(missing));
  return missing.empty() ? success : check_failed;
}

}  // namespace

void add_plan(CLI::App& app, Session& session, int& result, const RunCommandLine& run) {
  const auto options = std::make_shared<PlanOptions>();
  const auto add_run = [&](CLI::App* command) {
    add_option(*command, "run RUN", options->run, "the folder of a plan")->required();
  };
  CLI::App* plan =
      app.add_subcommand("plan", "cut a sweep or a study into shards for a cluster or any shell");
  plan->allow_extras();
  add_option(*plan, "--shards N", options->shards, "at most so many")
      ->check(CLI::Range(std::uint64_t{1}, most_shards));
  add_option(
      *plan, "--shard-time T", options->shard_time,
      "as many that each takes about so long, as 30min, by the seconds of earlier runs or of "
      "a sample that is timed now");
  add_option(*plan, "--out RUN", options->run, "the folder of the plan")->required();
  plan->callback(
      [=, &session, &result] { result = make_plan(session, *options, plan->remaining(), run); });
  CLI::App* shard = app.add_subcommand("shard", "run one shard of a plan");
  add_run(shard);
  add_option(*shard, "shard K", options->shard, "its number, from 0")
      ->required()
      ->check(CLI::Range(std::uint64_t{0}, most_shards));
  shard->callback([=, &session, &result] { result = run_shard(session, *options, run); });
  CLI::App* merged = app.add_subcommand("merge", "the files of the whole plan, from its shards");
  add_run(merged);
  add_option(*merged, "--out DIR", options->out, "folder for the files; default: RUN/out");
  merged->add_flag("--resubmit", options->resubmit,
                   "where shards are missing, write resubmit.sh with an array of just these");
  merged->callback([=, &session, &result] { result = merge(session, *options, run); });
  CLI::App* status = app.add_subcommand("status", "which shards of a plan are done");
  add_run(status);
  status->callback([=, &result] { result = tell_status(*options); });
}

}  // namespace odeum::cli
