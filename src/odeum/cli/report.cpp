// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <chrono>

#include "odeum/cli/session.hpp"
#include "odeum/report/page.hpp"
#include "odeum/report/summary.hpp"
#include "odeum_build_info.hpp"

namespace odeum::cli {
namespace {

struct Options : StudyOptions {
  bool quick = false;
};

void run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const report::OutputFolder folder(options.out);
  const std::string fingerprint = fmt::format("{} quick={}", build::version, options.quick);
  report::Journal converged(folder, "converge", fingerprint, options.resume);
  report::Journal stable(folder, "stability", fingerprint, options.resume);

  report::ReportData data;
  data.quick = options.quick;
  data.command_line = options.quick ? "odeum report --quick" : "odeum report";
  study::ConvergenceOptions convergence;
  convergence.quick = options.quick;
  convergence.jobs = options.jobs_or_cores();
  data.convergence = study::converge(convergence, &converged);
  study::StabilityOptions stability;
  stability.jobs = options.jobs_or_cores();
  if (options.quick) {
    stability.own_grid = 65;
    stability.peer_grid = 17;
  }
  data.stability = study::measure_stability(stability, &stable);
  data.proofs =
      study::prove({.solvers = {}, .quick = options.quick, .jobs = options.jobs_or_cores()});
  write_csv(data.convergence, folder);
  write_csv(data.stability, folder);
  write_csv(data.proofs, folder);
  report::describe(data, all_cases(), all_libraries());
  data.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report::write_page(data, folder);
  converged.finish();
  stable.finish();
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
