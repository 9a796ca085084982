// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cli/kept_results.hpp"
#include "odeum/cli/problems.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/record/archive.hpp"
#include "odeum/report/report.hpp"
#include "odeum/report/text.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/questions.hpp"
#include "odeum/studies/runner.hpp"
#include "odeum/trajectories/report_parts.hpp"

namespace odeum::cli {
namespace {

struct Options : StudyOptions {
  bool quick = false;
  std::vector<std::string> cases;  ///< globs of --case
  ProblemOptions problems;
  std::vector<std::string> given;  ///< globs, from the problems; empty: none were given
};

/// The ids that globs of a study and globs of the user both match; `own` where none are given.
std::vector<std::string> intersection(const std::vector<std::string>& own,
                                      const std::vector<std::string>& given,
                                      const std::vector<std::string>& ids) {
  if (given.empty()) return own;
  std::vector<std::string> left;
  for (const std::string& id : ids)
    if (any_glob_matches(own, id) && any_glob_matches(given, id)) left.push_back(id);
  return left;
}

/// What is left of the runs of a study by --case and --solver.
std::vector<study::Options> restricted_to(std::vector<study::Options> runs, const Options& options,
                                          bool takes_cases) {
  const std::vector<std::string> cases = known_ids();
  std::vector<std::string> solvers;
  for (const Solver& solver : all_solvers()) solvers.push_back(solver.info.id());
  std::vector<study::Options> left;
  for (study::Options& run : runs) {
    run.cases =
        intersection(run.cases, takes_cases ? options.cases : std::vector<std::string>(), cases);
    run.solvers = intersection(run.solvers, options.solvers, solvers);
    const bool empty = (run.cases.empty() && takes_cases && !options.cases.empty()) ||
                       (run.solvers.empty() && !options.solvers.empty());
    if (!empty) left.push_back(std::move(run));
  }
  return left;
}

/// The runs of a study: on the cases that were named, or those that it declares for a report.
std::vector<study::Options> runs_of(const study::Study& study, const Options& options) {
  const bool takes_cases = !study.declaration().cases_help.empty();
  if (options.given.empty())
    return restricted_to(study.report_runs(options.quick), options,
                         takes_cases && study.declaration().on_cases);
  if (!takes_cases) return {};
  study::Options run{.cases = options.given, .solvers = options.solvers};
  // A study without quick runs has one result, which the command of that study may have kept.
  run.quick = options.quick && !study.declaration().quick_help.empty();
  // Times are measured anew, with the short limits of a report.
  if (!study.declaration().no_resume.empty())
    if (const auto& own = study.report_runs(options.quick); !own.empty()) run.own = own.front().own;
  return {run};
}

/// The cases of the report.
std::vector<const Case*> cases_of(const Options& options) {
  return study::select_cases(options.given.empty() ? std::vector<std::string>{"*"} : options.given);
}

/// Runs what each study has of its own for a report, adds what earlier runs left of the rest, and
/// writes the files of what was measured.
void run_studies(const Session& session, const study::Studies& studies, const Options& options,
                 const std::optional<record::OutputFolder>& folder, record::Store* store) {
  for (const auto& study : studies) {
    const study::Declaration& declaration = study->declaration();
    const std::vector<study::Options> runs = runs_of(*study, options);
    bool partial = runs.empty();
    for (const study::Options& run : runs) {
      record::Store* const kept =
          declaration.no_resume.empty() || !session.assignment.is_alone() ? store : nullptr;
      study->measure(run,
                     study::Runner(options.jobs_or_cores(), result_cache_of(session, kept, run)));
      partial = partial || !run.cases.empty() || !run.solvers.empty();
    }
    if (folder && partial && options.given.empty()) study->add_earlier(folder->path());
  }
  if (!folder) return;
  for (const auto& study : studies)
    if (study->measured()) study->write(*folder, options.jobs_or_cores());
}

void run(const Session& session, const Options& options) {
  check_case_globs(options.cases);
  const auto start = std::chrono::steady_clock::now();
  shards::require_planned_content(session.assignment, session.content);
  std::optional<record::OutputFolder> out;
  if (const std::string path = session.assignment.output(options.out); !path.empty())
    out.emplace(path);
  const study::Studies studies = study::make_studies();
  const auto store = open_store(session, options);
  try {
    run_studies(session, studies, options, out, store.get());
  } catch (const Interrupted&) {
    throw Stopped(resume_hint(store.get()));
  }
  shards::require_kept(session.assignment, store.get());
  if (!out) return;
  const record::OutputFolder& folder = *out;
  const unsigned jobs = options.jobs_or_cores();
  report::Report report(facts_for(session, cases_of(options), jobs), folder, jobs);
  for (const auto& study : studies)
    if (options.given.empty() || study->measured()) {
      report.study(study->facts());
      study->show(report);
    }
  trajectories::add_solutions(
      report, options.given.empty() ? study::quick_cases() : std::vector<std::string>(),
      study::result_of<study::ConvergenceResult>(studies),
      study::result_of<study::PrecisionResult>(studies), options.jobs_or_cores());
  if (options.given.empty() && any_glob_matches(options.cases, trajectories::replayed_case))
    trajectories::add_replays(report, folder, options.jobs_or_cores());
  std::string command = "odeum report";
  for (const std::string& word : options.problems.words) command += " " + word;
  if (options.quick) command += " --quick";
  for (const std::string& glob : options.cases) command += " --case '" + glob + "'";
  for (const std::string& glob : options.solvers) command += " --solver '" + glob + "'";
  if (store) report.manifest("results_of_earlier_runs", store->taken());
  const bool written = report.write(
      {.command_line = command,
       .quick = options.quick,
       .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
  remark_on_page(written);
  folder.write(record::archive_name, record::archive_of(folder.path()));
  const std::filesystem::path at = written ? folder.path() / "index.html" : folder.path();
  print(study::summary_text(report.facts(),
                            study::result_of<study::ConvergenceResult>(studies).orders) +
        fmt::format("report: {}\n", report::plain(at.string())));
  if (session.assignment.is_alone()) remark_on(store.get());
}

}  // namespace

void add_report(CLI::App& app, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("report", "the whole comparison: tables, plots and a page");
  command->add_flag("--quick", options->quick,
                    "nine cases, each in full but for the orders on the cloth; coarser regions");
  add_option(*command, "--case GLOB", options->cases,
             "only these of the cases that a report measures, with * and ?; !GLOB excludes");
  add_study_options(*command, *options);
  add_problem_options(*command, options->problems);
  command->callback([options, &session] {
    check_solver_globs(options->solvers);  // before truths are computed
    options->given = load_problems(session, options->problems, {});
    check_case_globs(options->given);
    run(session, *options);
  });
}

}  // namespace odeum::cli
