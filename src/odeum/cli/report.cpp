// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <list>

#include "odeum/cli/session.hpp"
#include "odeum/cli/study_command.hpp"
#include "odeum/report/old_page.hpp"
#include "odeum/report/summary.hpp"
#include "odeum/studies/material/material.hpp"

namespace odeum::cli {
namespace {

struct Options : StudyOptions {
  bool quick = false;
};

/// Runs what each study has of its own for a report, adds what earlier runs left of the rest, and
/// writes the files of what was measured.
void run_studies(const study::Studies& studies, const Options& options,
                 const record::OutputFolder& folder) {
  std::list<record::Journal> journals;
  for (const auto& study : studies) {
    const study::Declaration& declaration = study->declaration();
    const std::vector<study::Options> runs = study->report_runs(options.quick);
    record::Journal* journal = nullptr;
    if (!runs.empty() && declaration.no_resume.empty()) {
      study::Options mark{.quick = options.quick};
      for (const study::Options& run : runs) mark.own["report"] += run.text();
      journal =
          &journals.emplace_back(folder, declaration.name, journal_mark(mark), options.resume);
    }
    bool partial = runs.empty();
    for (const study::Options& run : runs) {
      study->measure(run, study::Runner(options.jobs_or_cores(), journal));
      partial = partial || !run.cases.empty() || !run.solvers.empty();
    }
    if (partial) study->add_earlier(folder.path());
  }
  for (const auto& study : studies)
    if (study->measured()) study->write(folder);
  for (record::Journal& journal : journals) journal.finish();
}

const study::Study& named(const study::Studies& studies, const std::string& name) {
  return **std::find_if(studies.begin(), studies.end(),
                        [&](const auto& study) { return study->declaration().name == name; });
}

report::ReportData data_of(const study::Studies& studies, bool quick) {
  report::ReportData data;
  data.quick = quick;
  data.command_line = quick ? "odeum report --quick" : "odeum report";
  data.convergence = study::result_of<study::ConvergenceResult>(studies);
  data.stability = study::result_of<study::StabilityResult>(studies);
  data.proofs = study::result_of<study::ProofResult>(studies);
  data.precision = study::result_of<study::PrecisionResult>(studies);
  data.precision_problem = named(studies, "precision").problem();
  if (named(studies, "precision").measured())
    data.precision_seconds_limit = study::report_seconds_per_solve;
  data.material = study::result_of<study::MaterialResult>(studies);
  data.material.problem = named(studies, "material").problem();
  data.hard_cases.drift = study::result_of<study::DriftResult>(studies);
  data.hard_cases.largest_steps = study::result_of<study::LimitsResult>(studies).rows;
  data.hard_cases.reduction = study::result_of<study::ReductionResult>(studies).rows;
  for (const char* name : {"drift", "limits", "reduction"}) {
    const std::string& problem = named(studies, name).problem();
    data.hard_cases.problem += (data.hard_cases.problem.empty() ? "" : "; ") + problem;
    data.hard_cases.measured = data.hard_cases.measured || named(studies, name).measured();
  }
  return data;
}

void run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const record::OutputFolder folder(options.out);
  const study::Studies studies = study::make_studies();
  try {
    run_studies(studies, options, folder);
  } catch (const Interrupted&) {
    throw Stopped("the same command with --resume continues");
  }
  report::ReportData data = data_of(studies, options.quick);
  static_cast<report::Facts&>(data) = report::describe(all_cases(), all_libraries());
  data.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report::write_page(data, folder);
  print(report::summary_table(data, folder));
}

}  // namespace

void add_report(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("report", "the whole comparison: tables, plots and a page");
  command->add_flag("--quick", options->quick, "fewer step sizes, coarser regions");
  add_study_options(*command, *options, false);
  command->callback([options, &result] {
    run(*options);
    result = success;
  });
}

}  // namespace odeum::cli
