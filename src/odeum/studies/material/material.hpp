// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odeum/scene/model/scene.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/studies/material/rows.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// Whether a solver is included: every one with the step of a physics engine.
bool is_compared(const SolverInfo& info, const Options& options);

/// All five files. Throws Interrupted.
MaterialResult measure_material(const Options& options, const Runner& runner = Runner());

/// A hanging chain with known static and dynamic response: `masses` equal masses below a fixed
/// point, each on a spring of rest length `length`. Weights are small, so that every strain is
/// below 1 %.
struct Specimen {
  std::string name;
  std::size_t masses = 1;
  double mass = 0.1;        ///< kg
  double stiffness = 1000;  ///< N/m
  double damping = 1;       ///< N s/m
  double length = 1;        ///< m
  double gravity = 1;       ///< m/s^2

  /// Of the slowest mode: angular frequency (1/s) without damping, damping ratio, and the mode's
  /// shape, 1 at the lowest mass.
  double frequency() const;
  double damping_ratio() const;
  std::vector<double> shape() const;
  /// Sag of the lowest mass under gravity, m.
  double sag() const;
  scene::Scene scene() const;
};
Specimen one_mass();
Specimen hanging_chain();  ///< ten masses

/// Solvers on a specimen, or any other scene, with an initial state that may be changed between
/// solves.
struct SceneStage {
  explicit SceneStage(const scene::Scene& scene);
  std::shared_ptr<std::vector<double>> y0;  ///< all positions, then all velocities
  Entrants entrants;
};

/// Iterations per step, by the options of these names; 0: the engine's default.
struct Iterations {
  std::uint64_t sweeps = 0, newton = 0;
  void ask(Request& request) const {
    if (sweeps > 0) request.options["sweeps"] = static_cast<double>(sweeps);
    if (newton > 0) request.options["newton"] = static_cast<double>(newton);
  }
};

/// Lets the specimen settle under gravity, then oscillate in its slowest mode, at steps of about
/// `step` seconds.
MaterialRow measure_response(const Specimen& specimen, const SceneStage& stage,
                             const Entrant& entrant, double step, const Iterations& iterations);
MaterialResult measure_responses(const Options& options, const Runner& runner = Runner());

/// The oscillator z'' + decay z' + omega_squared (z - rest) = 0 that passes through the samples of
/// a motion: exactly so for any linear scheme of two unknowns.
struct Vibration {
  double omega_squared = 0;  ///< k/m, 1/s^2
  double decay = 0;          ///< d/m, 1/s
  std::string reason = {};   ///< why no oscillator fits, a sentence; empty: one does
};

/// Fits z[j + lag] = a z[j] + b z[j - lag] + c by least squares and takes the logarithms of the
/// roots of x^2 = a x + b; the lag is about a sixth of a turn. Samples are `step` s apart; z starts
/// displaced, with velocity 0.
Vibration fit_vibration(const std::vector<double>& z, double step);

/// RMS distance over particles of the positions (the first 3 `particles` entries) of two states.
double rms_distance(const std::vector<double>& a, const std::vector<double>& b,
                    std::size_t particles);

/// The runs from which an error is split.
struct SplitPlan {
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

/// A row for each number of steps and each of plan.tried; library and solver are left empty.
std::vector<ErrorPartsRow> split_error(const SplitPlan& plan, const RunCloth& run,
                                       const std::vector<double>& truth);
MaterialResult measure_error_parts(const Options& options, const Runner& runner = Runner());

/// Particles along an edge of the cloths that run long and whose errors are split, and of that on
/// which explicit and implicit steps are timed.
inline constexpr std::size_t cloth_side = 11, timed_cloth_side = 32;
/// How long that runs (s, a whole number of every frame), to what its linear systems are solved,
/// and its explicit steps over the largest stable one.
inline constexpr double timed_cloth_time = 8.0 / 30, timed_cloth_residual = 1e-2,
                        timed_cloth_margin = 0.9;

/// Drape, energy and momentum of cloths over 10 s.
MaterialResult measure_long_runs(const Options& options, const Runner& runner = Runner());

/// Own engines, timed alternately on one processor.
std::vector<ClothCostRow> measure_cloth_cost(const std::vector<std::size_t>& sides,
                                             double seconds_each);
std::vector<ImplicitWinsRow> measure_implicit_wins(std::size_t side,
                                                   const std::vector<double>& stiffnesses,
                                                   const std::vector<double>& frames,
                                                   double seconds_each);

}  // namespace odeum::study
