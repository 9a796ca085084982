// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/problem/extended_problem.hpp"
#include "odeum/scene/model/scene.hpp"

namespace odeum::scene {

/// The equation of MassSpring in extended precision, spring by spring, its data the doubles of the
/// scene. Without a truth.
ExtendedProblem extended_mass_spring(const Scene& scene);

}  // namespace odeum::scene
