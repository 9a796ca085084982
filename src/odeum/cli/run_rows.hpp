// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "odeum/measure/run_record.hpp"
#include "odeum/record/table.hpp"
#include "odeum/trajectories/run_page.hpp"

namespace odeum::cli {

/// One solver's run, for programs.
struct RunRow : measure::RunRecord {
  double end = nan, reached = nan;  ///< the last time, and that whose state was recorded
  /// The error at `error_time`, the last output at which the truth is known (nan: at none); the
  /// largest at the stops of a run whose steps end on several.
  /// `error` times `error_unit` is the error of `error_component` in its own unit.
  double error_time = nan;
  std::string error_component;
  double error_unit = nan, floor = nan;
  std::string truth;
  bool diverged = false;  ///< the run ended ok and is not a solution of any accuracy

  static constexpr const char* file = "runs";
  ODEUM_COLUMNS(case_id, library, solver, mode,
                column("step", ComputedColumn{mode == Mode::fixed ? setting : nan}),
                column("tolerance", ComputedColumn{mode == Mode::fixed ? nan : setting}), end,
                status, detail, reached, counters.steps, counters.rejected_steps,
                counters.rhs_evaluations, counters.jacobian_evaluations, error_time,
                error_component, error_unit, column("error_max", error), error_rms, floor, judged,
                truth)
};
struct RunRows {
  std::vector<RunRow> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// The row of a run, with its error at the last stop at which the truth is known; of a run whose
/// steps end on several stops the largest at them. For a run to a tolerance it measures the
/// amplification of errors, which may take longer than the run.
RunRow row_of(const Case& c, const trajectories::CaseRun& run);

/// `82 evaluations, 3 Jacobians, 214 products in linear solvers`.
std::string cost_text(const Counters& counters);

/// The text of a run whose error waits for the truth: how it ended, and its end state where it has
/// few numbers. `seconds`: of the processor.
std::string first_text(const trajectories::CaseRun& run, std::size_t numbers, double seconds);

/// Lines: the error, whether the tolerance explains it, and what else the run shows.
std::string error_text(const Case& c, const trajectories::CaseRun& run, const RunRow& row);

}  // namespace odeum::cli
