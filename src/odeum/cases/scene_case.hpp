// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/solvers/entrants.hpp"

namespace odeum::cases {

/// Every solver, own and of each library, enrolled on a scene from its start at time 0; with
/// `odeum/closed_form` for free particles under a constant force.
Entrants enroll_scene(const std::shared_ptr<const scene::SceneProblem>& problem);

/// A scene of the project: a file of cases/scenes, built in.
struct SceneText {
  std::string_view name;  ///< the file's stem
  std::string_view text;
};
const std::vector<SceneText>& all_scenes();

}  // namespace odeum::cases
