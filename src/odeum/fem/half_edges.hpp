// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "odeum/core/team.hpp"
#include "odeum/fem/triangle_mesh.hpp"

namespace odeum::fem {

/// The edges of every triangle in its own direction. Where triangles do not overlap, each stands
/// once, and again in the other direction where another triangle has it too.
struct HalfEdges {
  std::vector<int> start;                    ///< by node: where those that leave it begin
  std::vector<int> to;                       ///< the nodes in which they end, rising for each node
  std::vector<std::array<int, 2>> boundary;  ///< those without the opposite one, by first node
};

/// None where ids are out of range or a triangle has a node twice, where two triangles overlap at
/// an edge, a node belongs to no triangle, or the mesh is in more than one piece; `check` says
/// which.
std::optional<HalfEdges> half_edges(const TriangleMesh& mesh, Team& team);

}  // namespace odeum::fem
