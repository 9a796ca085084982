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
  /// At `error_time`, the last output at which the truth is known; nan: at none. Of a run whose
  /// steps end on several stops the largest at them.
  double error_time = nan, error_max = nan, error_rms = nan, floor = nan;
  judge::JudgedAnswer judged;
  std::string truth;

  static constexpr const char* file = "runs";
  ODEUM_COLUMNS(case_id, library, solver, mode, step, tolerance, end, status, detail, reached,
                counters.steps, column("rejected", counters.rejected_steps),
                column("evaluations", counters.rhs_evaluations),
                column("jacobians", counters.jacobian_evaluations), error_time, error_max,
                error_rms, floor, judged, truth)
};
struct RunRows {
  std::vector<RunRow> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// Whether a run ended ok and is no solution, of whatever accuracy.
bool has_diverged(const Case& c, const trajectories::CaseRun& run);

RunRows rows_of(const Case& c, const std::vector<trajectories::CaseRun>& runs);

/// Lines: the error at the end, or at the last output at which it is known, whether the tolerance
/// explains it, and what else the run shows.
std::string error_text(const Case& c, const trajectories::CaseRun& run);

}  // namespace odeum::cli
