// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "odeum/judge/answer.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::trajectories {

/// The exact motion beside the runs of a scene; nothing where none is known or asked for.
struct SceneTruth {
  std::shared_ptr<const scene::SceneProblem> problem;  ///< whose states the truth has
  Truth truth = {};
};

/// The errors of a scene's run at its frames, as far as the truth is known.
struct SceneErrors {
  double largest = 0;      ///< of a free particle at any frame, m
  double largest_at = 0;   ///< the time of that, s
  double end_largest = 0;  ///< at the last frame with a known truth, m
  double end_mean = 0;     ///< there, over the free particles, m
  double until = 0;        ///< the time of that frame, s; 0: no truth at any frame
  double size = 0;         ///< of the scene: the largest extent of exact positions, m
};
SceneErrors scene_errors(const scene::SceneProblem& problem, const scene::RunResult& run,
                         const Truth& truth);

/// The times of the runs' frames at which a truth is worth its cost, ascending: each, or every
/// so-manyth where there are many of many particles; the last of each run is among them.
std::vector<double> times_to_judge(const std::vector<const scene::RunResult*>& runs);

/// Why the energy at a frame is more than the scene can have, as a sentence; empty where it is not,
/// or where that is not known, with negative damping. Springs, drag, contacts and magnetic fields
/// add nothing to the energy that particles have at the start or at their birth; wind adds at most
/// c w^2 / 4 a second to each. A method's own error of energy may be as large as what is exchanged:
/// the energy of springs and motion at the start, and what gravity has given; where forces
/// dissipate, twice that above the lowest energy before.
std::string excess_of_energy(const scene::Scene& scene, const scene::RunResult& run);

/// The answer of a scene's run: wrong where it has blown up (`excess`, see excess_of_energy), where
/// pairs passed through each other, and where it has diverged, by more than the size of the scene;
/// else what part of that size the error is. No amplification is measured. `errors`: null where no
/// truth was asked for or is known.
judge::JudgedAnswer scene_answer(const scene::RunResult& run, Mode mode, const std::string& excess,
                                 const SceneErrors* errors);

/// How deep the surfaces of a run were in their thickness, and what passed through: a line of
/// `odeum run`.
std::string text_of_contacts(const scene::Contacts& contacts);

}  // namespace odeum::trajectories
