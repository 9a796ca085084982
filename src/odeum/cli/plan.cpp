// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "odeum/cli/kept_results.hpp"
#include "odeum/cli/problems.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/core/checksum.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/shards/job_scripts.hpp"
#include "odeum/shards/shards.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::cli {
namespace {

namespace fs = std::filesystem;

struct PlanOptions {
  std::string run, out, shard_time;
  std::uint64_t shards = 0, shard = 0;
  bool resubmit = false;
};

std::string program_sum() { return fmt::format("{:016x}", checksum(mark_of_program())); }

double seconds_of(const std::string& shard_time) {
  return number_of("--shard-time", shard_time,
                   {{"", 1}, {"ms", 1e-3}, {"s", 1}, {"min", 60}, {"h", 3600}});
}

void print_plan(const PlanOptions& options, const study::PlannedTasks& foreseen,
                const shards::MadePlan& made) {
  const std::uint64_t count = made.file.shards;
  print("plan    {} tasks in {} shards\n", foreseen.seconds.size(), count);
  print(
      "time    {:.3g} s foreseen, the longest shard {:.3g} s ({} tasks timed, {} of earlier "
      "runs)\n",
      made.seconds, made.longest, foreseen.timed, foreseen.earlier);
  if (count < options.shards)
    print("note    fewer than {} shards, since a task is not split\n", options.shards);
  print(
      "slurm   sh {0}/submit.sh\nhere    seq 0 {1} | xargs -P {2} -n 1 odeum shard {0}\n"
      "then    odeum merge {0} --out DIR\n",
      shell_word(options.run), count - 1, made.file.first_alone < count ? 1 : 2);
}

void check_words(const PlanOptions& options, const std::vector<std::string>& words) {
  if (words.empty())
    throw UsageError("plan: no command; expected one: odeum plan converge --shards 8 --out RUN");
  if ((options.shards == 0) == options.shard_time.empty())
    throw UsageError("plan needs --shards or --shard-time, and not both");
  const study::Studies studies = study::make_studies();
  if (words.front() != "sweep" && words.front() != "report" &&
      std::ranges::none_of(
          studies, [&](const auto& each) { return each->declaration().name == words.front(); }))
    throw UsageError("plan: {} cannot be done in shards; sweep and the studies can", words.front());
}

int make_plan(Session& session, const PlanOptions& options, const std::vector<std::string>& words,
              const RunCommandLine& run) {
  check_words(options, words);
  const double shard_seconds = options.shard_time.empty() ? 0 : seconds_of(options.shard_time);
  const auto foreseen = std::make_shared<study::PlannedTasks>();
  session.assignment.role = shards::Role::plan;
  session.assignment.share.plan = foreseen;
  const record::OutputFolder folder(options.run);
  seconds_of_tasks(session);  // the user's, and not the plan's
  shards::prepare(folder);
  if (const int code = run(words, session); code != success) return code;
  if (foreseen->seconds.empty())
    throw UsageError("{} has no tasks that shards could do; nothing was planned", words.front());
  const shards::MadePlan made = shards::make_plan(
      folder, {.program = program_sum(), .content = session.content, .words = words}, *foreseen,
      static_cast<double>(options.shards), shard_seconds);
  print_plan(options, *foreseen, made);
  return success;
}

int run_shard(Session& here, const PlanOptions& options, const RunCommandLine& run) {
  const shards::PlanFile plan = shards::read_plan(options.run);
  if (options.shard >= plan.shards)
    throw UsageError("shard {}: the plan has shards 0 to {}", options.shard, plan.shards - 1);
  shards::require_same_program(plan, program_sum());
  here.assignment.run = fs::absolute(options.run);
  std::string fault;
  const shards::Done done = shards::done(here.assignment.run, plan, options.shard, fault);
  if (done == shards::Done::yes) {
    remark("shard {} is there already", options.shard);
    return success;
  }
  if (done == shards::Done::damaged) remark("shard {} {}; it is run again", options.shard, fault);
  try {
    return shards::run_shard(
        here.assignment, plan, options.shard, [&](const auto& words) { return run(words, here); },
        [](int code) { return code == success || code == solver_failed; });
  } catch (const Interrupted&) {
    throw Stopped("the same command continues");
  }
}

/// A line for each of the first ten, and how many more there are.
std::string text_of(const shards::MissingShards& missing) {
  std::string text;
  constexpr std::size_t most = 10;
  for (std::size_t k = 0; k < std::min(missing.size(), most); ++k)
    text += fmt::format("missing shard {}: {}\n", missing[k].first, missing[k].second);
  if (missing.size() > most) text += fmt::format("        and {} more\n", missing.size() - most);
  return text;
}

int tell_missing(const PlanOptions& options, const shards::PlanFile& plan,
                 const shards::MissingShards& missing) {
  print(text_of(missing));
  if (options.resubmit) {
    std::vector<std::uint64_t> numbers;
    for (const auto& [shard, reason] : missing) numbers.push_back(shard);
    const record::OutputFolder of_plan(options.run);
    of_plan.write("resubmit.sh", shards::resubmit_script(numbers, plan.first_alone));
    print("slurm   sh {}/resubmit.sh\n", shell_word(options.run));
  }
  return check_failed;
}

int merge(Session& here, const PlanOptions& options, const RunCommandLine& run) {
  const shards::PlanFile plan = shards::read_plan(options.run);
  shards::require_same_program(plan, program_sum());
  here.assignment.run = fs::absolute(options.run);
  const fs::path out =
      options.out.empty() ? here.assignment.run / "out" : fs::absolute(options.out);
  if (const auto missing = shards::await_shards(here.assignment.run, plan); !missing.empty())
    return tell_missing(options, plan, missing);
  return shards::merge(here.assignment, plan, out,
                       [&](const auto& words) { return run(words, here); });
}

int tell_status(const PlanOptions& options) {
  const shards::PlanFile plan = shards::read_plan(options.run);
  const shards::MissingShards missing = shards::missing_of(plan, options.run);
  const auto begun =
      std::ranges::count(missing, shards::unfinished,
                         [](const auto& each) -> const std::string& { return each.second; });
  print("plan    odeum {}\nshards  {} of {} done, {} begun, {} tasks in all\n",
        fmt::join(plan.words, " "), plan.shards - missing.size(), plan.shards, begun,
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
      ->check(CLI::Range(std::uint64_t{1}, shards::most_shards));
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
      ->check(CLI::Range(std::uint64_t{0}, shards::most_shards));
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
