// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/answer.hpp"
#include "odeum/record/table.hpp"
#include "odeum/trajectories/run_page.hpp"

namespace odeum::cli {

/// One solver's run, for programs.
struct RunRow {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  double step = nan, tolerance = nan, end = nan;
  Status status = Status::ok;
  std::string detail;
  Counters counters;
  double reached = nan;  ///< the last time whose state was recorded
  /// The error at `error_time`, the last output at which the truth is known (nan: at none); the
  /// largest at the stops of a run whose steps end on several.
  /// `error_max` times `error_unit` is the error of `error_component` in its own unit.
  double error_time = nan;
  std::string error_component;
  double error_unit = nan, error_max = nan, error_rms = nan, floor = nan;
  judge::JudgedAnswer judged;
  std::string truth;

  static constexpr const char* file = "runs";
  ODEUM_COLUMNS(case_id, library, solver, mode, step, tolerance, end, status, detail, reached,
                counters.steps, counters.rejected_steps, counters.rhs_evaluations,
                counters.jacobian_evaluations, error_time, error_component, error_unit, error_max,
                error_rms, floor, judged, truth)
};
struct RunRows {
  std::vector<RunRow> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// The error of a run at the last stop at which the truth is known; of a run whose steps end on
/// several stops the largest at them.
struct RunError {
  bool known = false;     ///< nothing else is without it, as of a run that did not end ok
  std::string component;  ///< whose error is the largest
  double unit = nan;      ///< of that component there, see ErrorUnits
  double time = nan;
  judge::StopError error;
  double floor = nan;
  judge::JudgedAnswer judged;
  bool diverged = false;  ///< the run ended ok and is not a solution of any accuracy
};

/// The error of a run. For a run to a tolerance it measures the amplification of errors, which may
/// take longer than the run.
RunError error_of(const Case& c, const trajectories::CaseRun& run);

/// `errors`: of each run.
RunRows rows_of(const Case& c, const std::vector<trajectories::CaseRun>& runs,
                const std::vector<RunError>& errors);

/// `82 evaluations, 3 Jacobians, 214 products in linear solvers`.
std::string cost_text(const Counters& counters);

/// The text of a run whose error waits for the truth: how it ended, and its end state where it has
/// few numbers. `seconds`: of the processor.
std::string first_text(const trajectories::CaseRun& run, std::size_t numbers, double seconds);

/// Lines: the error, whether the tolerance explains it, and what else the run shows.
std::string error_text(const Case& c, const trajectories::CaseRun& run, const RunError& error);

}  // namespace odeum::cli
