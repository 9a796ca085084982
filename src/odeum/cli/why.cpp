// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "odeum/cases/conditions.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/cli/run_rows.hpp"
#include "odeum/core/clocks.hpp"
#include "odeum/problem/events.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/trajectories/run_page.hpp"
#include "odeum/truth/system.hpp"
#include "odeum/why/why_answer.hpp"

namespace odeum::cli {
namespace {

struct WhyOptions {
  std::string what, solver, format = "table", out;
  double seconds = 20;
  RunSettings settings;
  ProblemOptions problems;
};

/// The run that is asked about, with its states over time as far as it came.
trajectories::CaseRun run_with_outputs(const Case& c, const why::Why& why) {
  trajectories::CaseRun run{c.entrants.find(why.solver), why.request, {}};
  if (why.outcome.status == Status::refused) {
    run.outcome = why.outcome;
    return run;
  }
  const double end = run.request.stops.back();
  if (why.outcome.status == Status::over_budget) run.request.stops = {why.reached};
  ask_for_output(run.request, {}, c.t0, c.y0.size());
  // The budget covers what was looked at, and a step aside at each output.
  run.request.budget.evaluations = 2 * why.outcome.counters.work + 100'000;
  run.outcome = run.entrant->solve(run.request);
  if (run.request.stops.back() != end) run.request.stops.push_back(end);
  if (why.outcome.status == Status::ok && run.outcome.status == Status::ok)
    std::ranges::copy(why.outcome.states,
                      run.outcome.states.end() - static_cast<std::ptrdiff_t>(c.y0.size()));
  // How it ended and what it took is that of the run without outputs.
  run.outcome.status = why.outcome.status;
  run.outcome.detail = why.outcome.detail;
  run.outcome.t = why.outcome.t;
  run.outcome.counters = why.outcome.counters;
  return run;
}

/// The run and the better one with their states over time, for the page, whose curves go by name:
/// the same solver at another setting is `same`, with that in its name.
std::vector<trajectories::CaseRun> shown_runs(const Case& c, const why::Why& why, Entrant& same) {
  std::vector<trajectories::CaseRun> runs{run_with_outputs(c, why)};
  if (!why.better) return runs;
  const why::Other& other = why.others[*why.better];
  if (other.request.stops != why.request.stops) return runs;
  same = *runs.front().entrant;
  same.info.method += " " + why::setting_of(other.request, c);
  Request request = other.request;
  ask_for_output(request, {}, c.t0, c.y0.size());
  request.budget.evaluations = 2 * other.counters.work + 100'000;
  const Entrant& entrant = other.id() == why.solver ? same : *c.entrants.find(other.id());
  runs.push_back({&entrant, request, trajectories::solve_with_outputs(entrant, request)});
  return runs;
}

/// What is said of the run, as `odeum run` says it.
RunRow row_of(const Case& c, const why::Why& why) {
  return trajectories::row_of(c, {c.entrants.find(why.solver), why.request, why.outcome});
}

void write_files(const record::OutputFolder& folder, const Case& c, const why::Why& why,
                 const RunRow& row, const std::string& text, const std::string& json,
                 const advise::Asked& asked) {
  folder.write("why.txt", text);
  folder.write("why.json", json);
  trajectories::RunTexts texts{.title = c.title,
                               .lead = c.id,
                               .facts = {{"Why", why::first_line(why)}},
                               .bounds = why::segments_of(why),
                               .command = "odeum why"};
  for (const why::Finding& finding : why.findings)
    texts.facts.emplace_back(why::name_of(finding.cause), finding.text);
  if (const std::string next = why::command_of(why, c, asked); !next.empty())
    texts.facts.emplace_back("Next", next);
  folder.write("why.csv", texts.bounds.csv());
  Entrant same;
  const std::vector<trajectories::CaseRun> runs = shown_runs(c, why, same);
  std::vector<RunRow> rows{row};
  if (runs.size() > 1) rows.push_back(trajectories::row_of(c, runs.back()));
  remark_on_page(trajectories::write_case_page(folder, c, runs, rows, texts));
}

int why_on(Session& session, const WhyOptions& options, const CLI::App& command) {
  require_positive("--seconds", options.seconds);
  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  // A truth that takes longer is known in part, or not at all.
  constexpr double for_truth = 0.25, least = 0.5;
  const auto start = std::chrono::steady_clock::now();
  session.truth_bounds.until =
      start + std::chrono::milliseconds(std::llround(1e3 * for_truth * options.seconds));
  const Case c = case_within(session, options.what, options.problems, options.settings);
  if (c.problem.events && c.problem.events->isolated) require_no_events(c, "why");
  const RunSettings settings = settings_for(c, options.settings);
  if (!has_setting(settings)) throw UsageError("why needs --step or --tol, or --rtol and --atol");
  // One that does not fit is a cause, too, beside which others are named.
  const Entrant* const listed = c.entrants.find(with_library(options.solver));
  const Entrant& entrant = listed ? *listed : find_entrant(c.entrants, c.id, options.solver);
  const Request request = make_request(settings, c.t0, c.end(), c.y0.size(), entrant.info);
  const why::Why why =
      why::why(c, entrant.info.id(), request,
               std::max(least * options.seconds, options.seconds - seconds_since(start)),
               cases::conditions_of(c));
  const advise::Asked asked{shell_word(options.what), words_of(options.problems.sets, command)};
  const RunRow row = row_of(c, why);
  auto json = why::json_of(why, c, asked);
  for (const record::Field& field : record::fields_of(row))
    std::visit([&](const auto& value) { json["run"][field.column] = value; }, field.value);
  const std::string text = why::text_of(why, c, asked, answer_and_remarks(row)),
                    json_text = json.dump(2) + "\n";
  print(options.format == "json"  ? json_text
        : options.format == "csv" ? why::segments_of(why).csv()
                                  : text);
  if (folder) write_files(*folder, c, why, row, text, json_text, asked);
  return success;
}

}  // namespace

void add_why(CLI::App& app, Session& session, int& result) {
  const auto options = std::make_shared<WhyOptions>();
  CLI::App* command = app.add_subcommand(
      "why", "what a run spends its steps on, why it failed or crawls, and what does better");
  add_option(*command, "problem CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu", options->what,
             "a case, a scene, a problem's file, or an FMU")
      ->required();
  add_option(*command, "--solver ID", options->solver, "the solver of the run")->required();
  add_problem_options(*command, options->problems, false);
  add_step_and_tolerances(*command, options->settings);
  add_option(*command, "--until T", options->settings.until, "end time; default: the horizon");
  add_option(*command, "--seconds S", options->seconds,
             "for the answer, the truth included; default: {}");
  add_format(*command, options->format);
  add_option(*command, "--out DIR", options->out,
             "folder for the files: index.html, why.csv, why.json, trajectory.csv, ...");
  command->callback(
      [options, command, &session, &result] { result = why_on(session, *options, *command); });
}

}  // namespace odeum::cli
