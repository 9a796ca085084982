// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/limits/limits.hpp"

#include <fmt/format.h>

#include "odeum/cli/session.hpp"

namespace odeum::cli {
namespace {

std::string limits_table(const std::vector<study::LargestStep>& rows) {
  std::string text = fmt::format("{:<29} {:<40} {:>10} {:>10} {:>22}  {}\n", "case", "solver",
                                 "measured", "predicted", "eigenvalue", "remark");
  for (const study::LargestStep& row : rows)
    text += fmt::format("{:<29} {:<40} {:>10.4g} {:>10.4g} {:>10.3g} {:>+10.3g}i  {}{}{}\n",
                        row.case_id, row.library + "/" + row.solver, row.largest_stable_step,
                        row.predicted_step, row.eigenvalue.real(), row.eigenvalue.imag(),
                        row.status, row.detail.empty() ? "" : ": ", row.detail);
  return text;
}

}  // namespace

void add_limits(CLI::App& app, int& result) {
  struct Options : StudyOptions {
    study::LimitsOptions study;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "limits", "the largest stable step on hard cases, beside what the spectrum predicts");
  command
      ->add_option("--case", options->study.cases, "cases, with * and ?; default: the stiff ones")
      ->type_name("GLOB");
  add_study_options(*command, *options);
  command->callback([options, &result] {
    if (options->resume) throw UsageError("--resume: limits keeps no journal, it takes minutes");
    check_case_globs(options->study.cases);
    check_solver_globs(options->solvers);
    options->study.solvers = options->solvers;
    options->study.jobs = options->jobs_or_cores();
    const record::OutputFolder folder(options->out);
    const std::vector<study::LargestStep> measured = study::measure_limits(options->study);
    write_csv(measured, folder);
    print(limits_table(measured));
    remark(fmt::format("largest_steps.csv is in {}", options->out));
    result = success;
  });
}

}  // namespace odeum::cli
