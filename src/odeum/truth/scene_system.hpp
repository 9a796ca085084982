// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// A scene from its start, as a system for references: its forces in extended precision where it
/// has gravity and a few springs alone, else those of the scene, in double. Several threads may
/// call it.
System system_of(const std::shared_ptr<const scene::SceneProblem>& problem);

/// Operations of one evaluation of its forces and of a step's vectors, estimated from its terms.
double work_of(const scene::SceneProblem& problem);

}  // namespace odeum::truth
