// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/judge/order_fit.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::study {

/// One solve: a line of convergence.csv. Errors are absolute, in the case's units, over all stops
/// and measured components; NaN where the solve failed or the case has no energy.
struct ConvergenceRow {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  std::string status;  ///< a Status, or not_applicable
  std::string detail;
  double step = 0;       ///< adaptive: the mean step
  double tolerance = 0;  ///< adaptive; NaN at a fixed step
  std::uint64_t steps = 0;
  double error_max = 0, error_rms = 0;
  double energy_error = 0;  ///< relative to the largest |energy| of the truth at the stops
  Counters counters;
};

/// The error of one solve at one stop: a line of convergence_times.csv.
struct TimeRow {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  double step = 0, time = 0;
  double error_max = 0, error_rms = 0;
  double energy = 0, energy_error = 0;
};

/// The order of one solver on one case: a line of orders.csv.
struct OrderRow {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  double claimed_order = 0;
  judge::OrderFit fit;
};

struct ConvergenceResult {
  std::vector<ConvergenceRow> rows;
  std::vector<TimeRow> times;
  std::vector<OrderRow> orders;
};

struct ConvergenceOptions {
  std::vector<std::string> cases;    ///< globs on case ids; empty: all
  std::vector<std::string> solvers;  ///< globs on library/method; empty: all
  std::vector<Mode> modes;           ///< empty: both
  bool quick = false;                ///< fewer step sizes
  unsigned jobs = 1;
};

/// Error against step for every fitting pair. Results do not depend on `jobs`. With a journal,
/// pairs that it holds are not run again. Throws Interrupted.
ConvergenceResult converge(const ConvergenceOptions& options, record::Journal* journal = nullptr);

/// The CSV files of a result: convergence.csv, convergence_times.csv, orders.csv.
void write_csv(const ConvergenceResult& result, const record::OutputFolder& folder);

}  // namespace odeum::study
