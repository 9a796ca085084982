// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "odeum/scene/model/scene.hpp"
#include "odeum/solvers/entrants.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// Whether a solver is included: every one with the step of a physics engine.
bool is_compared(const SolverInfo& info, const Options& options);

/// Solvers on a scene, with an initial state that may be changed between
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

/// RMS distance over particles of the positions (the first 3 `particles` entries) of two states.
double rms_distance(const std::vector<double>& a, const std::vector<double>& b,
                    std::size_t particles);

}  // namespace odeum::study
