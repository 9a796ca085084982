// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/record/rows.hpp"
#include "odeum/studies/stopwatch.hpp"

/// What the study of engines and cloths finds. A row names its columns once, in `each`; its file is
/// written and read by that.
namespace odeum::study {

/// What a solver makes of springs of known stiffness and damping: a line of material.csv.
struct MaterialRow {
  std::string scene;  ///< one_mass, hanging_chain
  std::string library, solver;
  /// A Status, `unstable`, `not_applicable`, or `unmeasured` where it ran but numbers are missing.
  std::string status, detail;
  double step = nan;                     ///< s
  std::uint64_t sweeps = 0;              ///< option of the engine; 0: its own
  std::uint64_t newton = 0;              ///< option of the engine; 0: its own
  double phase = nan;                    ///< step times the slowest mode's frequency, radians
  double static_stiffness_ratio = nan;   ///< stiffness shown at rest / nominal
  double dynamic_stiffness_ratio = nan;  ///< stiffness shown by the slowest mode / nominal
  double damping = nan;                  ///< damping shown by the slowest mode / nominal
  double added_damping_ratio = nan;      ///< damping ratio shown less the nominal one

  static constexpr const char* file = "material.csv";
  static constexpr const char* shown =
      "scene solver step:.3g sweeps newton static_stiffness_ratio:.3g dynamic_stiffness_ratio:.3g "
      "damping:.3g added_damping_ratio:.2g status";
  static constexpr int schema = 2;  ///< 2: the names of both stiffness ratios
  static void each(auto& row, auto&& visit) {
    visit("scene", row.scene), visit("library", row.library), visit("solver", row.solver);
    visit("status", row.status), visit("step", row.step), visit("sweeps", row.sweeps);
    visit("newton", row.newton), visit("phase", row.phase);
    visit("static_stiffness_ratio", row.static_stiffness_ratio);
    visit("dynamic_stiffness_ratio", row.dynamic_stiffness_ratio), visit("damping", row.damping);
    visit("added_damping_ratio", row.added_damping_ratio), visit("detail", row.detail);
  }
};

/// Where the error of a cloth comes from: a line of material_error.csv. Errors are RMS distances of
/// particles in m; the parts are steps of one path from the run to the truth, so that `total` is at
/// most their sum.
struct ErrorPartsRow {
  std::string library, solver, status, detail;
  double time = nan, step = nan;         ///< s
  std::uint64_t sweeps = 0, newton = 0;  ///< as in MaterialRow
  double total = nan;                    ///< run to truth
  double iteration = nan;                ///< run to the same with iterations converged; 0: none
  double time_step = nan;                ///< that to its limit h -> 0
  double model = nan;                    ///< that limit to the truth
  /// How far the limits may be off: of iterations at this step, and of the step.
  double iteration_left = nan, step_left = nan;

  static constexpr const char* file = "material_error.csv";
  static constexpr const char* shown =
      "solver step:.3g sweeps newton total:.2g iteration:.2g time_step:.2g model:.2g status";
  static void each(auto& row, auto&& visit) {
    visit("library", row.library), visit("solver", row.solver), visit("status", row.status);
    visit("time", row.time), visit("step", row.step), visit("sweeps", row.sweeps);
    visit("newton", row.newton), visit("total", row.total), visit("iteration", row.iteration);
    visit("time_step", row.time_step), visit("model", row.model);
    visit("iteration_left", row.iteration_left), visit("step_left", row.step_left);
    visit("detail", row.detail);
  }
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
  static void each(auto& row, auto&& visit) {
    visit("scene", row.scene), visit("library", row.library), visit("solver", row.solver);
    visit("status", row.status), visit("setting_kind", row.setting_kind);
    visit("setting", row.setting), visit("time", row.time), visit("quantity", row.quantity);
    visit("value", row.value), visit("reference", row.reference);
    visit("reference_source", row.reference_source), visit("detail", row.detail);
  }
};

/// What a step of a cloth costs a particle: a line of cloth_cost.csv.
struct ClothCostRow {
  std::uint64_t side = 0;                          ///< particles along an edge of the square
  std::string precision;                           ///< f64, f32
  double wall_ns_min = nan, wall_ns_median = nan;  ///< a particle and step
  std::uint64_t repetitions = 0;
  Conditions conditions;

  static constexpr const char* file = "cloth_cost.csv";
  static constexpr bool keeps_earlier = true;
  static void each(auto& row, auto&& visit) {
    visit("side", row.side), visit("precision", row.precision);
    visit("wall_ns_min", row.wall_ns_min), visit("wall_ns_median", row.wall_ns_median);
    visit("repetitions", row.repetitions), visit("drift", row.conditions.drift);
    visit("processor_share", row.conditions.processor_share);
    visit("measured", row.conditions.measured);
  }
};

/// One way to step a cloth of one stiffness at one frame: a line of implicit_wins.csv.
struct ImplicitWinsRow {
  double stiffness = nan;  ///< N/m
  double frame = nan;      ///< s; of explicit engines NaN, they step as they can
  std::string engine;      ///< verlet_f32, imex_f32, implicit_f64
  std::string status, detail;
  double step = nan;                               ///< s
  double wall_ns_min = nan, wall_ns_median = nan;  ///< a simulated second
  std::uint64_t repetitions = 0;
  /// RMS distance of particles from a run of RK4 in f64 (m), and of that from one at twice its
  /// step. No independent truth exists at this size.
  double rk4_distance = nan, rk4_left = nan;
  Conditions conditions;

  static constexpr const char* file = "implicit_wins.csv";
  static constexpr int schema = 2;
  static constexpr bool keeps_earlier = true;
  static void each(auto& row, auto&& visit) {
    visit("stiffness", row.stiffness), visit("frame", row.frame), visit("engine", row.engine);
    visit("status", row.status), visit("step", row.step), visit("wall_ns_min", row.wall_ns_min);
    visit("wall_ns_median", row.wall_ns_median), visit("repetitions", row.repetitions);
    visit("rk4_distance", row.rk4_distance), visit("rk4_left", row.rk4_left);
    visit("drift", row.conditions.drift), visit("processor_share", row.conditions.processor_share);
    visit("measured", row.conditions.measured), visit("detail", row.detail);
  }
};

struct MaterialResult {
  std::vector<MaterialRow> material;
  std::vector<ErrorPartsRow> errors;
  std::vector<LongRunRow> long_run;
  std::vector<ClothCostRow> cost;
  std::vector<ImplicitWinsRow> implicit_wins;
  static auto lists(auto& result) {
    return std::tie(result.material, result.errors, result.long_run, result.cost,
                    result.implicit_wins);
  }
};

}  // namespace odeum::study
