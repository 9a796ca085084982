// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/record/output_folder.hpp"
#include "odeum/report/report.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/precision/precision.hpp"

/// What a report has beside the sections of its studies.
namespace odeum::trajectories {

inline constexpr const char* replayed_case = "cloth11_two_way";

/// A replay of the report.
struct ReplayRow {
  std::string case_id, library, solver, setting, status, detail;
  std::uint64_t steps = 0, rhs_evaluations = 0;  ///< Bullet's own bodies evaluate none
  /// The largest distance of a particle from the exact motion, m; NaN where no run gave that.
  double error = nan;
  std::string remark, replay;

  static constexpr const char* file = "replays.csv";
  ODEUM_COLUMNS(case_id, library, solver, status, detail, setting, steps, rhs_evaluations, error,
                remark, replay)
};

/// The replays of a case with a scene, in replay/, and their rows.
std::vector<ReplayRow> write_replays(const Case& c, const record::OutputFolder& folder,
                                     unsigned jobs);

/// Runs the cloth with own integrators and those of Bullet, beside the exact motion, and writes
/// their replays, with the error as colour, into replay/ and rows of them into the report. Nothing
/// where the report has no cloth. Throws Interrupted.
void add_replays(report::Report& report, const record::OutputFolder& folder, unsigned jobs);

/// Makes the cheap runs of both studies again, with output, on those cases of the report whose
/// ids `cases` holds (empty: on all), and hands them to the report: data/solutions-<number>.js.
/// Throws Interrupted.
void add_solutions(report::Report& report, const std::vector<std::string>& cases,
                   const study::ConvergenceResult& converged, const study::PrecisionResult& timed,
                   unsigned jobs);

}  // namespace odeum::trajectories
