// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/answer.hpp"
#include "odeum/solvers/settings.hpp"

namespace odeum::measure {

/// One run of a solver on a case at a setting. The rows of all questions derive from it, so that
/// what they write of a run is filled here alone and means the same:
///
///   struct Row : measure::RunRecord {
///     ODEUM_COLUMNS(case_id, library, solver, status, setting, error, counters.steps)
///   };
///
/// Errors are those of judge::over_stops, in the units of the case; NaN where the run failed.
struct RunRecord {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  double setting = nan;  ///< the step, or the relative tolerance
  std::string status;    ///< a Status, or not_applicable
  std::string detail;
  Counters counters;
  double error = nan, error_rms = nan;
  double energy_error = nan;   ///< NaN where the case has no energy, too
  judge::JudgedAnswer judged;  ///< where it was asked for

  bool ok() const { return status == to_string(Status::ok); }
  /// The setting and how the run ended, without errors. `run`: an Outcome, or that of a scene.
  void take(const SolverInfo& info, double t0, const Request& request, const auto& run) {
    library = info.library;
    solver = info.method;
    mode = request.mode;
    setting = setting_of(request, t0);
    status = to_string(run.status);
    detail = run.detail;
    counters = run.counters;
  }
  void take(const Case& c, const SolverInfo& info, const Request& request, const Outcome& outcome) {
    case_id = c.id;
    take(info, c.t0, request, outcome);
  }
  /// One entry a stop; none: the run failed.
  void take_errors(const std::vector<judge::StopError>& errors);
};

/// The answer of a run that ended well. `amplification`: at the stops of the errors, of a run to a
/// tolerance; `floor`: the truth's; `scale`: Judge::scale.
judge::JudgedAnswer answer_of(const Request& request, const Outcome& outcome,
                              const std::vector<judge::StopError>& errors,
                              const judge::Amplification& amplification, double floor,
                              double scale);

}  // namespace odeum::measure
