// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// A scene from its start, as a system for references: its forces in extended precision where it
/// has gravity and a few springs alone, else those of the scene, in double. Several threads may
/// call it.
System system_of(const std::shared_ptr<const scene::SceneProblem>& problem);

/// A reference of a scene at the times (ascending, after 0). Emitted particles, which touch no
/// other ones, are computed one by one, each from its birth to its death.
Reference reference_of(const std::shared_ptr<const scene::SceneProblem>& problem,
                       const std::vector<double>& times, const TruthBounds& bounds = {});

/// Operations of one evaluation of its forces and of a step's vectors, estimated from its terms.
double work_of(const scene::SceneProblem& problem);

}  // namespace odeum::truth
