// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

#include "odeum/scene/model/scene.hpp"

namespace odeum::cases {

/// A square cloth of n x n particles in the unit square, each joined to its neighbours one and two
/// away along rows, columns and diagonals, the column j = n - 1 fixed. The middle, the particles
/// with 3 <= i, j <= n - 3, has an initial velocity. (The index of the reference says n - 4;
/// integrating its data back to t = 0 gives n - 3, see reports/findings.md.)
scene::Scene square_cloth(std::size_t n, double stiffness, bool tension_only = false);

}  // namespace odeum::cases
