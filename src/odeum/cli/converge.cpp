// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "odeum/cli/session.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum_build_info.hpp"

namespace odeum::cli {
namespace {

// One line a (case, solver, mode): the verdict for people; the files hold the rest.
std::string order_table(const study::ConvergenceResult& result) {
  std::string text = fmt::format("{:<30} {:<44} {:<8} {:>7} {:>8}  {}\n", "case", "solver", "mode",
                                 "claimed", "measured", "verdict");
  for (const study::OrderRow& row : result.orders) {
    text += fmt::format("{:<30} {:<44} {:<8} {:>7.3g} {:>8.3f}  {}{}{}\n", row.case_id,
                        row.library + "/" + row.solver, to_string(row.mode), row.claimed_order,
                        row.fit.order, to_string(row.fit.verdict),
                        row.fit.reason.empty() ? "" : ": ", row.fit.reason);
  }
  return text;
}

}  // namespace

void add_converge(CLI::App& app, int& result) {
  struct Options : StudyOptions {
    study::ConvergenceOptions study;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("converge", "error against step, and the order that it shows");
  command->add_option("--case", options->study.cases, "cases, with * and ?")->type_name("GLOB");
  command->add_flag("--quick", options->study.quick, "fewer step sizes");
  add_study_options(*command, *options);
  command->callback([options, &result] {
    check_case_globs(options->study.cases);
    check_solver_globs(options->solvers);
    options->study.solvers = options->solvers;
    options->study.jobs = options->jobs_or_cores();
    const record::OutputFolder folder(options->out);
    record::Journal journal(
        folder, "converge",
        fmt::format("{} {} {} {}", build::version, options->study.quick,
                    fmt::join(options->study.cases, " "), fmt::join(options->solvers, " ")),
        options->resume);
    const study::ConvergenceResult measured = study::converge(options->study, &journal);
    write_csv(measured, folder);
    journal.finish();
    print(order_table(measured));
    remark(fmt::format("convergence.csv, convergence_times.csv and orders.csv are in {}",
                       options->out));
    result = success;
  });
}

}  // namespace odeum::cli
