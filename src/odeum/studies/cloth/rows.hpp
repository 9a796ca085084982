// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/record/rows.hpp"

namespace odeum::study {

/// Where the error of a cloth comes from: a line of material_error.csv. Errors are RMS distances of
/// particles in m; the parts are steps of one path from the run to the truth, so that `total` is at
/// most their sum.
struct ErrorPartsRow {
  std::string library, solver, status, detail;
  double time = nan, step = nan;         ///< s
  std::uint64_t sweeps = 0, newton = 0;  ///< iterations given to an engine; 0: its own
  double total = nan;                    ///< run to truth
  double iteration = nan;                ///< run to the same with iterations converged; 0: none
  double time_step = nan;                ///< that to its limit h -> 0
  double model = nan;                    ///< that limit to the truth
  /// How far the limits may be off: of iterations at this step, and of the step.
  double iteration_left = nan, step_left = nan;

  static constexpr const char* file = "material_error.csv";
  static constexpr const char* shown =
      "solver step:.3g sweeps newton total:.2g iteration:.2g time_step:.2g model:.2g status";
  ODEUM_COLUMNS(library, solver, status, time, step, sweeps, newton, total, iteration, time_step,
                model, iteration_left, step_left, detail)
};

/// A quantity of a cloth in a long run at one time: a line of cloth_long.csv.
struct LongRunRow {
  std::string scene;  ///< hanging, free
  std::string library, solver, status, detail;
  std::string setting_kind;  ///< step, tol
  double setting = nan;      ///< s, or relative and absolute tolerance
  double time = nan;         ///< s
  /// `drape` (RMS distance of particles from the reference, m), `lowest` (lowest height, m),
  /// `energy` (J), `linear_momentum`, `angular_momentum` (change over the first value).
  std::string quantity = "none";
  double value = nan;
  double reference = nan;
  std::string reference_source =
      "none";  ///< the file of cases/reference, or the methods that agree

  static constexpr const char* file = "cloth_long.csv";
  static constexpr int schema = 2;
  ODEUM_COLUMNS(scene, library, solver, status, setting_kind, setting, time, quantity, value,
                reference, reference_source, detail)
};

struct ClothResult {
  std::vector<ErrorPartsRow> errors;
  std::vector<LongRunRow> long_run;
  static auto lists(auto& result) { return std::tie(result.errors, result.long_run); }
};

}  // namespace odeum::study
