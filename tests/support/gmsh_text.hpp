// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <string>

#include "odeum/fem/triangle_mesh.hpp"

namespace odeum::tests {

/// A square of two triangles with a named edge, as Gmsh writes it: nodes 1 to 4 in two blocks.
inline constexpr const char* gmsh_square = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "lower edge"
2 9 "plate"
$EndPhysicalNames
$Entities
1 1 1 0
1 0 0 0 0
3 0 0 0 1 0 0 1 7 2 1 -2
5 0 0 0 1 1 0 1 9 1 3
$EndEntities
$Nodes
2 4 1 4
1 3 0 2
1
2
0 0 0
1 0 0
2 5 1 2
3
4
1 1 0 1 1
0 1 0 0 1
$EndNodes
$Elements
3 4 1 4
0 1 15 1
1 1
1 3 1 1
2 1 2
2 5 2 2
3 1 2 3
4 1 3 4
$EndElements
)";

/// A mesh in Gmsh's format, without entities; tags from 1.
inline std::string gmsh_text(const fem::TriangleMesh& mesh) {
  std::string text = fmt::format(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {0} 1 {0}\n2 1 0 {0}\n", mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) text += fmt::format("{}\n", i + 1);
  for (const fem::Point p : mesh.nodes) text += fmt::format("{} {} 0\n", p.x, p.y);
  text += fmt::format("$EndNodes\n$Elements\n1 {0} 1 {0}\n2 1 2 {0}\n", mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    text += fmt::format("{} {} {} {}\n", t + 1, mesh.triangles[t][0] + 1, mesh.triangles[t][1] + 1,
                        mesh.triangles[t][2] + 1);
  return text + "$EndElements\n";
}

}  // namespace odeum::tests
