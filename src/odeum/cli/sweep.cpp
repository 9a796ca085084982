// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "odeum/cli/run.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/input/yaml_tree.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/sweep/answer.hpp"
#include "odeum/sweep/study.hpp"

namespace odeum::cli {
namespace {

struct SweepOptions {
  std::string what, quantities, over_file, out, format = "table", study = "run";
  std::vector<std::string> over, solvers;
  double sample = 0, error = 0, seconds = 0;
  std::uint64_t seed = 1, check = 100;
  StudyOptions common;  ///< its number of threads
  RunSettings settings;
  ProblemOptions problems;
};

sweep::Members members_of(const SweepOptions& options) {
  if (options.over.empty() == options.over_file.empty())
    throw UsageError("sweep needs --over or --over-file, and not both");
  if (!options.over_file.empty()) {
    if (options.sample > 0) throw UsageError("--sample: the members are those of --over-file");
    constexpr std::size_t most_bytes = 2'000'000'000;
    return sweep::Members::of_csv(options.over_file,
                                  read_text_file(options.over_file, "members", most_bytes));
  }
  std::vector<sweep::Axis> axes;
  for (const std::string& text : options.over) {
    try {
      axes.push_back(sweep::axis_of(text));
    } catch (const std::invalid_argument& error) {
      throw UsageError("--over {}: {}", shown(text), error.what());
    }
  }
  const auto most = static_cast<double>(sweep::most_members);
  if (options.sample != std::floor(options.sample) || options.sample < 0 || options.sample > most)
    throw UsageError("--sample: got {}, expected a whole number up to {}", options.sample, most);
  return {axes, static_cast<std::uint64_t>(options.sample), options.seed};
}

/// Members are many, and have few outputs each.
Request with_outputs(Request request, const RunSettings& settings, const Case& c) {
  constexpr double outputs = 100;
  RunSettings few = settings;
  const double length = request.stops.back() - c.t0;
  const double h = length / static_cast<double>(request.steps);
  few.every = request.mode == Mode::fixed  // a whole number of steps
                  ? h * std::max(1., std::round(static_cast<double>(request.steps) / outputs))
                  : length / outputs;
  ask_for_output(request, few, c.t0, c.y0.size());
  request.record_steps = false;
  return request;
}

/// Throws UsageError for options that the study does not take.
void plan_study(const SweepOptions& options, const Case& c, const std::string& solver,
                sweep::Plan& plan) {
  const bool advice = options.study == "advise";
  if (has_setting(options.settings) || !options.quantities.empty())
    throw UsageError(
        "--study {}: chooses its settings and has quantities of its own; expected no "
        "--step, --tol or --quantity",
        options.study);
  if (advice && options.error == 0) throw UsageError("--study advise needs --error");
  if (advice) require_positive("--error", options.error);
  plan.solver = solver;
  if (!advice) {
    const Entrant& entrant = find_entrant(c.entrants, c.id, solver);
    plan.solver = entrant.info.id();
  } else if (!solver.empty()) {
    check_solver_globs({solver});
  }
  plan.study = sweep::member_study(
      options.study, {.solver = plan.solver, .error = options.error, .seconds = options.seconds});
  plan.quantities = plan.study->quantities;
}

sweep::Plan plan_of(const Session& session, const SweepOptions& options, const Case& c,
                    const std::string& solver) {
  sweep::Plan plan(c, members_of(options));
  plan.jobs = options.common.jobs_or_cores();
  if (options.study != "run") {
    plan_study(options, c, solver, plan);
    return plan;
  }
  if (options.error != 0 || options.seconds != 0)
    throw UsageError("--error and --seconds are those of --study advise and precision");
  const RunSettings settings = settings_for(c, options.settings);
  if (!has_setting(settings)) throw UsageError("sweep needs --step or --tol, or --rtol and --atol");
  const Entrant& entrant = find_entrant(c.entrants, c.id, solver);
  plan.solver = entrant.info.id();
  plan.request = make_request(settings, c.t0, c.end(), c.y0.size(), entrant.info);
  // One member among many does not hold up the others.
  plan.request.budget.evaluations = 20 * c.settings.evaluation_budget;
  plan.quantities = sweep::quantities_of(options.quantities, c);
  if (options.check > 0)
    if (const auto error = sweep::error_of_members(c)) plan.quantities.push_back(*error);
  plan.checks = options.check;
  const Request outputs = with_outputs(plan.request, settings, c);
  if (!session.assignment.output(options.out).empty()) plan.over_time = outputs;
  for (const sweep::Quantity& quantity : plan.quantities)
    if (quantity.over_time()) plan.request = outputs;
  return plan;
}

/// Without checks and studies no truth is asked for.
Case case_for(Session& session, const SweepOptions& options) {
  if (options.check > 0 || options.study != "run")
    return case_within(session, options.what, options.problems, options.settings);
  Case c = case_before_truth(session, cases::Named(options.what), options.problems);
  check_span(options.settings, c.t0, c.end());
  return c;
}

/// Advice needs none.
std::vector<std::string> solvers_of(const SweepOptions& options) {
  if (options.solvers.empty() && options.study != "advise")
    throw UsageError("--solver is required");
  return options.solvers.empty() ? std::vector<std::string>{""} : options.solvers;
}

int sweep_on(Session& session, const SweepOptions& options, const CLI::App& command) {
  try {
    std::optional<record::OutputFolder> folder;
    const std::string out = session.assignment.output(options.out);
    if (!out.empty()) folder.emplace(out);
    const Case c = case_for(session, options);
    std::vector<sweep::Plan> plans;
    for (const std::string& solver : solvers_of(options))
      plans.push_back(plan_of(session, options, c, solver));
    shards::require_planned_content(session.assignment, session.content);
    const auto store =
        session.assignment.is_alone() ? nullptr : shards::store_of(session.assignment);
    const sweep::Asked asked{shell_word(options.what), words_of(options.problems.sets, command)};
    std::vector<sweep::Result> results;
    std::string text;
    auto json = nlohmann::ordered_json::array();
    std::uint64_t solved = 0;
    for (sweep::Plan& plan : plans) {
      if (!session.assignment.is_alone())
        plan.kept = {.store = store.get(),
                     .dependencies = session.assignment.plan + session.content,
                     .share = session.assignment.share};
      results.push_back(sweep::run(plan));
      if (session.assignment.is_plan_or_shard()) continue;
      text += sweep::text_of(plan, results.back(), asked);
      json.push_back(sweep::json_of(plan, results.back(), asked));
      solved += results.back().solved;
    }
    shards::require_kept(session.assignment, store.get());
    if (session.assignment.is_plan_or_shard()) return success;
    if (json.size() == 1) json = nlohmann::ordered_json(json.front());
    const sweep::Joined all = sweep::join(plans, std::move(results));
    print(options.format == "json"  ? json.dump(2) + "\n"
          : options.format == "csv" ? all.result.csv
                                    : text);
    if (folder) {
      remark_on_page(sweep::write_page(*folder, all, text, json, asked));
      remark("members.csv is in {}", out);
    }
    return solved > 0 ? success : solver_failed;
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

void add_sweep(CLI::App& app, Session& session, int& result) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App* command =
      app.add_subcommand("sweep", "many runs of a problem with other values of its parameters");
  add_option(*command, "problem CASE|PROBLEM.yaml", options->what, "a case, or a problem's file")
      ->required();
  add_option(*command, "--over NAME=RANGE", options->over,
             "values of a parameter: k=0..5:6, k=1e2..1e6:log20, k=1,2,5, or drawn: "
             "k~uniform(0,5), k~loguniform(1,1e6), k~normal(1,0.1); several combine")
      ->allow_extra_args(false);
  add_option(*command, "--over-file FILE.csv", options->over_file,
             "the members themselves: a line of names, then a line of numbers for each");
  add_option(*command, "--sample N", options->sample, "how many values are drawn");
  add_option(*command, "--seed N", options->seed, "of the draws; default: {}")
      ->check(CLI::Range(0, 1'000'000'000));
  add_option(*command, "--solver ID", options->solvers,
             "a solver; several run on the same members. For advice, a glob")
      ->allow_extra_args(false);
  add_option(*command, "--study STUDY", options->study,
             "run; or of each member converge: its order, precision: its least times to errors, "
             "advise: the fastest solver to an error; default: {}")
      ->check(CLI::IsMember({"run", "converge", "precision", "advise"}));
  add_option(*command, "--error E", options->error, "with --study advise: the error that is asked");
  add_option(
      *command, "--seconds S", options->seconds,
      "with --study advise: for each answer; with precision: for the timed runs of a member");
  add_step_and_tolerances(*command, options->settings);
  add_option(*command, "--until T", options->settings.until, "end time; default: the horizon");
  add_option(
      *command, "--quantity LIST", options->quantities,
      "what is kept of each member: max(x), min(x), x(end), error(x) of a state or an output x, "
      "energy; default: the state at the end");
  add_option(*command, "--check N", options->check,
             "how many members are compared with a truth of their own, in at most 20 s; default: "
             "{}. With a closed form all are, and have a column error, unless N is 0")
      ->check(CLI::Range(0, 1'000'000'000));
  add_problem_options(*command, options->problems, false);
  add_option(*command, "--jobs N", options->common.jobs, "threads; default: one a core")
      ->check(CLI::Range(1, 1024));
  add_format(*command, options->format);
  add_option(*command, "--out DIR", options->out,
             "folder for the files: members.csv, sweep.json and a page with a map");
  command->callback(
      [options, command, &session, &result] { result = sweep_on(session, *options, *command); });
}

}  // namespace odeum::cli
