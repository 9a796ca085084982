// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <chrono>

#include "odeum/cli/session.hpp"
#include "odeum/report/old_page.hpp"
#include "odeum/report/summary.hpp"
#include "odeum/studies/material/material.hpp"
#include "odeum_build_info.hpp"

namespace odeum::cli {
namespace {

struct Options : StudyOptions {
  bool quick = false;
};

// One case of each kind: linear, orbits, many bodies, and three stiff ones.
const std::vector<std::string> timed_cases{"osc_under",  "kepler_e06", "pleiades",
                                           "vdp_mu1000", "hires",      "robertson_40"};

// Times for the page. A quick report takes those that lie in the folder already; a full one
// measures a few cases, with short limits, and keeps what an `odeum precision` left there of
// others.
void time_solvers(const Options& options, const record::OutputFolder& folder,
                  report::ReportData& data) {
  study::EarlierPrecision earlier = study::read_precision_csv(folder.path() / "precision.csv");
  if (!options.quick) {
    study::PrecisionOptions precision;
    precision.cases = timed_cases;
    precision.seconds_per_case = 1.1;
    precision.seconds_per_solve = data.precision_seconds_limit = 0.02;
    precision.attempts = 1;
    precision.jobs = options.jobs_or_cores();
    data.precision = study::measure_precision(precision);
  }
  study::add_earlier(data.precision, earlier.rows, all_cases());
  data.precision_problem = earlier.problem;
  if (!options.quick) write_csv(data.precision, folder);
}

// The studies of hard cases, likewise: a quick report shows what the folder holds.
void run_hard_cases(const Options& options, const record::OutputFolder& folder,
                    report::ReportData& data) {
  if (!options.quick) data.hard_cases = study::measure_hard_cases(options.jobs_or_cores());
  study::add_earlier(data.hard_cases, study::read_hard_cases(folder.path()), all_cases());
  if (!options.quick) write_csv(data.hard_cases, folder);
}

void run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const record::OutputFolder folder(options.out);
  const std::string fingerprint = fmt::format("{} quick={}", build::version, options.quick);
  record::Journal converged(folder, "converge", fingerprint, options.resume);
  record::Journal stable(folder, "stability", fingerprint, options.resume);

  report::ReportData data;
  data.quick = options.quick;
  data.command_line = options.quick ? "odeum report --quick" : "odeum report";
  data.convergence =
      study::converge({.quick = options.quick}, study::Runner(options.jobs_or_cores(), &converged));
  study::StabilityOptions stability;
  stability.jobs = options.jobs_or_cores();
  if (options.quick) {
    stability.own_grid = 65;
    stability.peer_grid = 17;
  }
  data.stability = study::measure_stability(stability, &stable);
  data.proofs =
      study::prove({.solvers = {}, .quick = options.quick, .jobs = options.jobs_or_cores()});
  run_hard_cases(options, folder, data);
  time_solvers(options, folder, data);
  // A quarter of a minute: a quick report shows what an earlier one left.
  data.material = options.quick
                      ? study::read_material_csv(folder.path())
                      : study::measure_material({.solvers = {}, .jobs = options.jobs_or_cores()});
  record::write(data.convergence, folder);
  write_csv(data.stability, folder);
  write_csv(data.proofs, folder);
  if (!options.quick) write_csv(data.material, folder);
  static_cast<report::Facts&>(data) = report::describe(all_cases(), all_libraries());
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
