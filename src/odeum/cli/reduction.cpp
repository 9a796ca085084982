// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/reduction/reduction.hpp"

#include <fmt/format.h>

#include "odeum/cli/session.hpp"

namespace odeum::cli {
namespace {

std::string reduction_table(const std::vector<study::ReductionRow>& rows) {
  std::string text = fmt::format("{:<40} {:>7} {:>7} {:>8} {:>9}  {}\n", "solver", "lambda",
                                 "claimed", "measured", "error", "verdict");
  for (const study::ReductionRow& row : rows)
    text += fmt::format("{:<40} {:>7.0e} {:>7.3g} {:>8.3f} {:>9.1e}  {}{}{}\n",
                        row.library + "/" + row.solver, row.lambda, row.claimed_order,
                        row.fit.order, row.error_finest, to_string(row.fit.verdict),
                        row.fit.reason.empty() ? "" : ": ", row.fit.reason);
  return text;
}

}  // namespace

void add_reduction(CLI::App& app, int& result) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command = app.add_subcommand(
      "reduction", "the order that is left on Prothero and Robinson's problem as it grows stiff");
  add_study_options(*command, *options);
  command->callback([options, &result] {
    if (options->resume) throw UsageError("--resume: reduction keeps no journal, it takes seconds");
    check_solver_globs(options->solvers);
    const record::OutputFolder folder(options->out);
    const std::vector<study::ReductionRow> measured =
        study::measure_reduction({.solvers = options->solvers, .jobs = options->jobs_or_cores()});
    write_csv(measured, folder);
    print(reduction_table(measured));
    remark(fmt::format("order_reduction.csv is in {}", options->out));
    result = success;
  });
}

}  // namespace odeum::cli
