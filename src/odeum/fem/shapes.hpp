// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

#include "odeum/fem/triangle_mesh.hpp"

/// Meshes of simple regions. All throw std::invalid_argument for fewer than one division.
namespace odeum::fem {

/// The unit square in 2 n^2 right triangles; nodes in rows, diagonals along (1, 1).
TriangleMesh unit_square(std::size_t n);

/// The same number of triangles, interior nodes moved at random by up to a fifth of the spacing in
/// x and in y, and each diagonal in either direction: always valid, and the same for a seed on
/// every machine.
TriangleMesh unstructured_square(std::size_t n, std::uint64_t seed);

/// [-1, 1]^2 without its quadrant x > 0, y < 0, in 6 n^2 right triangles: the reentrant corner is
/// at the origin.
TriangleMesh l_shape(std::size_t n);

/// A regular polygon of `corners` (at least 3) in the unit circle, a triangle to each edge. Refine
/// it with `onto_unit_circle` for the disc.
TriangleMesh polygon(std::size_t corners);
Point onto_unit_circle(Point p);

}  // namespace odeum::fem
