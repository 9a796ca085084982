// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/contest/solver.hpp"
#include "odeum/report/comparison.hpp"
#include "odeum/scene/run/run.hpp"

namespace odeum::cli {

/// One solver's run of a scene.
struct SceneRun {
  const Entrant* entrant;
  Request request;
  scene::RunResult result;
  std::string folder;  ///< of its files, with a slash at the end; empty: that of all files
};

/// A row for each run: status, steps, evaluations, energy.
report::Table scene_table(const std::vector<SceneRun>& runs);

/// The coordinate that the scene plots (else the height of its first free particle) over time and
/// in the state plane, and the energy; with the exact motion of free particles under gravity.
std::vector<report::Figure> scene_figures(const scene::Scene& scene,
                                          const scene::SceneProblem& problem,
                                          const std::vector<SceneRun>& runs);

}  // namespace odeum::cli
