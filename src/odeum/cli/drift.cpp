// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/drift/drift.hpp"

#include <fmt/format.h>

#include <cmath>

#include "odeum/cli/session.hpp"

namespace odeum::cli {
namespace {

// One line a (case, solver, invariant): the worst of it and how the run ended; the files hold the
// rest.
std::string drift_table(const study::DriftResult& result) {
  std::string text = fmt::format("{:<27} {:<40} {:<17} {:>9} {:>10} {:>10}  {}\n", "case", "solver",
                                 "invariant", "to time", "worst", "last", "status");
  for (std::size_t i = 0; i < result.rows.size();) {
    const study::DriftRow& first = result.rows[i];
    double worst = study::DriftRow::nan, latest = worst;
    std::size_t end = i;
    for (; end < result.rows.size(); ++end) {
      const study::DriftRow& row = result.rows[end];
      if (row.case_id != first.case_id || row.library != first.library ||
          row.solver != first.solver || row.invariant != first.invariant)
        break;
      if (std::isnan(row.relative_error)) continue;
      latest = row.relative_error;
      worst = std::fmax(worst, latest);
    }
    const study::DriftRow& last = result.rows[end - 1];
    text +=
        fmt::format("{:<27} {:<40} {:<17} {:>9.4g} {:>10.2e} {:>10.2e}  {}{}{}\n", first.case_id,
                    first.library + "/" + first.solver, first.invariant, last.time, worst, latest,
                    last.status, last.detail.empty() ? "" : ": ", last.detail);
    i = end;
  }
  return text;
}

std::string horizon_table(const study::DriftResult& result) {
  if (result.horizons.empty()) return "";
  std::string text = fmt::format("\n{:<27} {:<40} {:<9} {:>9} {:>10}  {}\n", "case", "solver",
                                 "mode", "setting", "1e-3 at", "status");
  for (const study::HorizonRow& row : result.horizons)
    text += fmt::format("{:<27} {:<40} {:<9} {:>9.2g} {:>10.2f}  {}{}{}\n", row.case_id,
                        row.library + "/" + row.solver, to_string(row.mode), row.setting,
                        row.horizon, row.status, row.detail.empty() ? "" : ": ", row.detail);
  return text;
}

}  // namespace

void add_drift(CLI::App& app, int& result) {
  struct Options : StudyOptions {
    study::DriftOptions study;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("drift", "what is left of energy and invariants after a long time");
  command->add_option("--case", options->study.cases, "cases, with * and ?")->type_name("GLOB");
  add_study_options(*command, *options);
  command->callback([options, &result] {
    if (options->resume) throw UsageError("--resume: drift keeps no journal, it takes a minute");
    check_case_globs(options->study.cases);
    check_solver_globs(options->solvers);
    options->study.solvers = options->solvers;
    options->study.jobs = options->jobs_or_cores();
    const record::OutputFolder folder(options->out);
    const study::DriftResult measured = study::measure_drift(options->study);
    write_csv(measured, folder);
    print(drift_table(measured) + horizon_table(measured));
    remark(fmt::format("drift.csv and horizons.csv are in {}", options->out));
    result = success;
  });
}

}  // namespace odeum::cli
