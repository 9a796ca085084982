// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <list>

#include "odeum/cli/session.hpp"
#include "odeum/cli/study_command.hpp"
#include "odeum/report/html.hpp"
#include "odeum/studies/convergence/section.hpp"

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

void run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const record::OutputFolder folder(options.out);
  const study::Studies studies = study::make_studies();
  try {
    run_studies(studies, options, folder);
  } catch (const Interrupted&) {
    throw Stopped("the same command with --resume continues");
  }
  report::Page page(report::describe(all_cases(), all_libraries()), folder);
  for (const auto& study : studies) study->section(page);
  page.write(
      {.command_line = options.quick ? "odeum report --quick" : "odeum report",
       .quick = options.quick,
       .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
  print(study::summary_text(page.facts(),
                            study::result_of<study::ConvergenceResult>(studies).orders) +
        fmt::format("report: {}\n", report::plain((folder.path() / "index.html").string())));
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
