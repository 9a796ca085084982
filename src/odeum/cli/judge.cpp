// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "odeum/brought/judgement.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/record/table.hpp"
#include "odeum/trajectories/run_page.hpp"
#include "odeum/truth/computed_truth.hpp"

namespace odeum::cli {
namespace {

struct JudgeOptions {
  std::string what, format = "table", out, claims, tube;
  std::vector<std::string> files, columns, solvers;
  std::vector<double> steps;
  double order = nan;
  ProblemOptions problems;
};

/// The files of the words, a folder's in the order of their names.
std::vector<std::string> files_of(const std::vector<std::string>& words) {
  std::vector<std::string> files;
  for (const std::string& word : words) {
    if (!std::filesystem::is_directory(word)) {
      files.push_back(word);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : std::filesystem::directory_iterator(word))
      if (const std::string extension = entry.path().extension().string();
          extension == ".csv" || extension == ".npy" || extension == ".txt" || extension == ".dat")
        inside.push_back(entry.path().string());
    if (inside.empty())
      throw UsageError("{}: the folder has no file that ends in .csv, .npy, .txt or .dat", word);
    std::ranges::sort(inside);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

brought::Claim claim_of(const JudgeOptions& options) {
  brought::Claim claim;
  if (!options.claims.empty()) {
    const std::string id = with_library(options.claims);
    check_solver_globs({id});
    const auto named =
        std::ranges::find(all_solvers(), id, [](const Solver& solver) { return solver.info.id(); });
    if (named == all_solvers().end() || named->info.library != "odeum")
      throw UsageError(
          "--claims: got {}, expected one of Odeum's own methods, see odeum list "
          "solvers",
          shown(options.claims));
    claim.method = named->info.method;
    claim.order = named->info.order;
  }
  if (!std::isnan(options.order)) {
    require_positive("--order", options.order);
    claim.order = options.order;
  }
  if (!options.tube.empty()) {
    const std::size_t comma = options.tube.find(',');
    claim.tube = number_of("--tube", options.tube.substr(0, comma), {{"", 1}});
    if (comma != std::string::npos)
      claim.tube_time = number_of("--tube", options.tube.substr(comma + 1), {{"", 1}});
    require_positive("--tube", claim.tube);
  }
  return claim;
}

std::vector<brought::Trajectory> read_files(const Case& c, const JudgeOptions& options) {
  brought::Reading reading;
  for (const std::string& text : options.columns)
    reading.columns.push_back(brought::column_of(text));
  const std::vector<std::string> files = files_of(options.files);
  if (!options.steps.empty() && options.steps.size() != files.size())
    throw UsageError("--steps: got {} steps, expected one for each of the {} files",
                     options.steps.size(), files.size());
  for (const double step : options.steps) require_positive("--steps", step);
  std::vector<brought::Trajectory> runs;
  for (std::size_t k = 0; k < files.size(); ++k)
    runs.push_back(brought::read_trajectory(c, files[k], reading,
                                            options.steps.empty() ? 0 : options.steps[k]));
  return runs;
}

/// Files as the runs of solvers, for the page that `odeum run` writes.
std::vector<trajectories::CaseRun> page_runs(const Case& c,
                                             const std::vector<brought::Trajectory>& runs,
                                             std::vector<Entrant>& entrants) {
  constexpr std::size_t most_runs = 12, most_times = 2000;
  std::vector<trajectories::CaseRun> shown_runs;
  entrants.reserve(runs.size());
  for (const brought::Trajectory& run : runs) {
    if (shown_runs.size() == most_runs || !run.is_whole(c)) continue;
    Entrant& entrant = entrants.emplace_back();
    entrant.info.library = "file";
    entrant.info.method = std::filesystem::path(run.file).stem().string();
    trajectories::CaseRun shown_run{&entrant, {}, {}};
    const std::size_t apart = 1 + run.rows() / most_times, n = c.y0.size();
    for (std::size_t row = run.rows() - 1; row > 0; row -= std::min(row, apart)) {
      shown_run.request.stops.insert(shown_run.request.stops.begin(), run.times[row]);
      shown_run.outcome.states.insert(shown_run.outcome.states.begin(), run.state(row),
                                      run.state(row) + n);
    }
    shown_run.request.steps = (run.rows() - 1) * run.steps_a_row;
    shown_run.outcome.t = run.times.back();
    shown_run.outcome.counters.steps = shown_run.request.steps;
    shown_runs.push_back(std::move(shown_run));
  }
  return shown_runs;
}

/// Runs of known solvers at the step, and with the outputs, of the finest file that has one.
void add_known(const Case& c, const std::vector<std::string>& solvers,
               std::vector<trajectories::CaseRun>& runs) {
  if (solvers.empty()) return;
  const auto finest = std::ranges::max_element(
      runs, {}, [](const trajectories::CaseRun& run) { return run.request.steps; });
  if (finest == runs.end() || finest->request.steps == 0)
    throw UsageError("--solver: no file has a known step at which the solvers could run");
  const Request request = finest->request;
  for (const std::string& word : solvers) {
    const std::string id = with_library(word);
    const Entrant* const entrant = c.entrants.find(id);
    if (!entrant || !entrant->unfit.empty() || !entrant->info.fixed)
      throw UsageError("--solver: {} {}", shown(id),
                       !entrant                 ? "is not known"
                       : entrant->unfit.empty() ? "does not run at fixed steps"
                                                : "does not fit: " + entrant->unfit);
    runs.push_back({entrant, request, entrant->solve(request)});
  }
}

void write_files(const record::OutputFolder& folder, const Case& c,
                 const std::vector<brought::Trajectory>& runs, const brought::Judgement& judgement,
                 const std::vector<std::string>& solvers) {
  record::write(judgement, folder);
  trajectories::RunTexts texts{.title = c.title,
                               .lead = c.id,
                               .facts = {{"Equation", c.equation},
                                         {"Truth", c.truth.source},
                                         {"Counts",
                                          "A file does not say how many evaluations its run took: "
                                          "0 stands for a number that is not known."}},
                               .command = "odeum judge"};
  for (const brought::SeriesRow& row : judgement.series) {
    if (row.claim != brought::Claimed::not_applicable)
      texts.facts.emplace_back(row.series + ", claim", to_string(row.claim));
    texts.facts.emplace_back(row.series, row.reason);
  }
  std::vector<Entrant> entrants;
  std::vector<trajectories::CaseRun> shown_runs = page_runs(c, runs, entrants);
  if (shown_runs.empty()) return;
  add_known(c, solvers, shown_runs);
  std::vector<trajectories::RunRow> rows;
  for (const trajectories::CaseRun& run : shown_runs) rows.push_back(trajectories::row_of(c, run));
  remark_on_page(trajectories::write_case_page(folder, c, shown_runs, rows, texts));
}

int judge_on(Session& session, const JudgeOptions& options) {
  const brought::Claim claim = claim_of(options);
  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  std::vector<brought::Trajectory> runs;
  std::vector<double> times;
  Case c = case_of(session, options.what, options.problems, [&](Case& before) {
    runs = read_files(before, options);
    times = brought::times_of(before, runs, claim);
    before.stops = times;
  });
  c.truth = truth::truth_at(c, times);
  const brought::Judgement judgement = brought::judge_runs(c, runs, claim);
  print(options.format == "json"  ? record::json_of(judgement)
        : options.format == "csv" ? record::csv_text(judgement.series)
                                  : brought::text_of(judgement, c));
  if (folder) write_files(*folder, c, runs, judgement, options.solvers);
  return judgement.passes() ? success : check_failed;
}

}  // namespace

void add_judge(CLI::App& app, Session& session, int& result) {
  const auto options = std::make_shared<JudgeOptions>();
  CLI::App* command = app.add_subcommand(
      "judge",
      "trajectories that another program wrote against the truth: their errors, order, and the "
      "method or the mistake whose numbers they are");
  add_option(*command, "problem CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu", options->what,
             "the problem that they solve")
      ->required();
  add_option(*command, "files FILE...", options->files,
             "CSV or NumPy's .npy, a row a time, or folders of these; runs of one program at "
             "several steps have one name but for the step, as in euler_h0.1.csv")
      ->required();
  add_option(*command, "--claims METHOD", options->claims,
             "the method that they are said to be, one of Odeum's own: exit code 1 where they are "
             "not");
  add_option(*command, "--order P", options->order, "the order that they are said to have");
  add_option(*command, "--map NAME=COLUMN", options->columns,
             "the column of a component, or of t, by its name or number; x=col2*0.001 multiplies "
             "it")
      ->allow_extra_args(false);
  add_option(*command, "--steps H,...", options->steps,
             "the step of each file; else it is in their names (h0.1, dt=0.1, n100) or the time "
             "between rows")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_option(*command, "--tube W[,T]", options->tube,
             "the largest error, and a shift in time that is allowed: exit code 1 where a time "
             "lies outside");
  add_option(*command, "--solver ID...", options->solvers,
             "with --out: known solvers beside the files on the page, at the finest of their steps")
      ->allow_extra_args(false);
  add_format(*command, options->format);
  add_option(*command, "--out DIR", options->out,
             "folder for the files: judged.csv, files.csv, trajectory.csv and a page");
  add_problem_options(*command, options->problems, false);
  command->callback([options, &session, &result] { result = judge_on(session, *options); });
}

}  // namespace odeum::cli
