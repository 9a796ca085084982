// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/precision.hpp"

#include <fmt/format.h>

#include <cmath>

#include "odeum/cli/session.hpp"

namespace odeum::cli {
namespace {

std::string ratio_of(const study::PrecisionSummary& line) {
  return line.reason.empty()
             ? fmt::format("{:.2f} ({:.2f} - {:.2f})", line.ratio, line.ratio_low, line.ratio_high)
             : line.reason;
}

// One line a case and error; the files hold the rest.
std::string summary_table(const study::PrecisionResult& result) {
  std::string text = fmt::format("{:<30} {:>7}  {:<34} {:>10}  {:<34} {:>10}  {}\n", "case",
                                 "error", "fastest own", "us", "fastest peer", "us", "peer / own");
  for (const study::PrecisionSummary& line : result.summary)
    text += fmt::format("{:<30} {:>7.0e}  {:<34} {:>10.1f}  {:<34} {:>10.1f}  {}\n", line.case_id,
                        line.error, line.own, line.own_ns / 1e3, line.peer, line.peer_ns / 1e3,
                        ratio_of(line));
  return text;
}

}  // namespace

void add_precision(CLI::App& app, int& result) {
  struct Options : StudyOptions {
    study::PrecisionOptions study;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("precision", "time against error, who is fastest where");
  command->add_option("--case", options->study.cases, "cases, with * and ?")->type_name("GLOB");
  command
      ->add_option("--seconds", options->study.seconds_per_case,
                   "what the timed runs of a case may take, roughly")
      ->capture_default_str();
  add_study_options(*command, *options);
  command->callback([options, &result] {
    if (options->resume)
      throw UsageError("--resume: times of two runs of the program do not compare");
    if (const double s = options->study.seconds_per_case; !std::isfinite(s) || !(s > 0))
      throw UsageError(fmt::format("--seconds: got {}, expected a positive number", s));
    check_case_globs(options->study.cases);
    check_solver_globs(options->solvers);
    options->study.solvers = options->solvers;
    options->study.jobs = options->jobs_or_cores();
    const record::OutputFolder folder(options->out);
    const study::PrecisionResult measured = study::measure_precision(options->study);
    write_csv(measured, folder);
    print(summary_table(measured));
    remark(fmt::format("precision.csv, precision_summary.csv and tolerances.csv are in {}",
                       options->out));
    result = success;
  });
}

}  // namespace odeum::cli
