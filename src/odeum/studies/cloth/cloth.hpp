// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/studies/scene_stage.hpp"

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
  std::vector<ErrorPartsRow> errors = {};
  std::vector<LongRunRow> long_run = {};
  static auto lists(auto& result) { return std::tie(result.errors, result.long_run); }
};

/// Particles along an edge.
inline constexpr std::size_t cloth_side = 11;

/// The runs from which an error is split.
struct SplitPlan {
  ErrorPartsRow blank = {};          ///< with the names of the solver
  double time = 0.25;                ///< s
  std::vector<std::uint64_t> steps;  ///< each twice the one before, at least three
  std::vector<Iterations> tried;
  Iterations converged, half;  ///< the largest number, and half of it to estimate its error
  double order = 1;            ///< of the step, for the extrapolation to h -> 0
};
/// Positions at plan.time; where the run failed, nothing and the reason.
struct Reached {
  std::optional<std::vector<double>> positions;
  std::string reason;
};
using RunCloth = std::function<Reached(std::uint64_t steps, const Iterations& iterations)>;

/// A row for each number of steps and each of plan.tried.
std::vector<ErrorPartsRow> split_error(const SplitPlan& plan, const RunCloth& run,
                                       const std::vector<double>& truth);
ClothResult measure_error_parts(const Options& options, const Runner& runner = Runner());

/// Drape, energy and momentum of cloths over 10 s.
ClothResult measure_long_runs(const Options& options, const Runner& runner = Runner());

}  // namespace odeum::study
