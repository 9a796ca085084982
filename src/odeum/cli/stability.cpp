// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "odeum/cli/session.hpp"
#include "odeum/studies/stability/stability.hpp"
#include "odeum_build_info.hpp"

namespace odeum::cli {
namespace {

std::string limit_table(const study::StabilityResult& result) {
  std::string text = fmt::format("{:<44} {:<11} {:>12} {:>12}  {}\n", "solver", "axis", "limit",
                                 "theory", "status");
  for (const study::StabilityLimit& row : result.limits)
    text += fmt::format("{:<44} {:<11} {:>12.7g} {:>12.7g}  {}{}{}\n",
                        row.library + "/" + row.solver, row.axis, row.limit, row.theory, row.status,
                        row.detail.empty() ? "" : ": ", row.detail);
  return text;
}

}  // namespace

void add_stability(CLI::App& app, int& result) {
  struct Options : StudyOptions {
    study::StabilityOptions study;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("stability", "regions and limits of stability of the running code");
  command->add_option("--plane", options->study.plane, "lambda or oscillator; default: both")
      ->check(CLI::IsMember({"lambda", "oscillator"}));
  auto grid = std::make_shared<int>(0);
  command->add_option("--grid", *grid, "points along an axis")
      ->type_name("N")
      ->check(CLI::Range(8, 4096));
  add_study_options(*command, *options);
  command->callback([options, grid, &result] {
    check_solver_globs(options->solvers);
    options->study.solvers = options->solvers;
    options->study.own_grid = options->study.peer_grid = *grid;
    options->study.jobs = options->jobs_or_cores();
    const record::OutputFolder folder(options->out);
    record::Journal journal(folder, "stability",
                            fmt::format("{} {} {} {}", build::version, options->study.plane, *grid,
                                        fmt::join(options->solvers, " ")),
                            options->resume);
    const study::StabilityResult measured = study::measure_stability(options->study, &journal);
    write_csv(measured, folder);
    journal.finish();
    print(limit_table(measured));
    remark(
        fmt::format("stability_limits.csv and the regions in stability/ are in {}", options->out));
    result = success;
  });
}

}  // namespace odeum::cli
