// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

#include "odeum/scene/model/scene.hpp"

namespace odeum::cases {

/// A square cloth of n x n particles in the unit square, each joined to its neighbours one and two
/// away along rows, columns and diagonals, the column j = n - 1 fixed, the middle thrown: the
/// particles with 3 <= i, j <= n - 3. (The index of the reference says n - 4; its data, followed
/// back to t = 0, says n - 3. See reports/findings.md.)
scene::Scene square_cloth(std::size_t n, double stiffness, bool tension_only = false);

}  // namespace odeum::cases
