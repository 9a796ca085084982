// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/studies/material/rows.hpp"
#include "odeum/studies/material/specimen.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// Whether a solver is included: every one with the step of a physics engine.
bool is_compared(const SolverInfo& info, const Options& options);

/// All five files. Throws Interrupted.
MaterialResult measure_material(const Options& options, const Runner& runner = Runner());

/// Solvers on a specimen, or any other scene, with an initial state that may be changed between
/// solves.
struct SceneStage {
  explicit SceneStage(const scene::Scene& scene);
  std::shared_ptr<std::vector<double>> y0;  ///< all positions, then all velocities
  std::vector<Entrant> entrants;
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
/// Positions at plan.time after this number of steps; where the run failed, nothing and the reason.
using RunCloth = std::function<std::optional<std::vector<double>>(
    std::uint64_t steps, const Iterations& iterations, std::string& reason)>;

/// A row for each number of steps and each of plan.tried; library and solver are left empty.
std::vector<ErrorPartsRow> split_error(const SplitPlan& plan, const RunCloth& run,
                                       const std::vector<double>& truth);
MaterialResult measure_error_parts(const Options& options, const Runner& runner = Runner());

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
