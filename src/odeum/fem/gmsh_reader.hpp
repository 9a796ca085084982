// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/fem/triangle_mesh.hpp"

namespace odeum::fem {

/// The triangles of a Gmsh file, and the lines of its curves.
struct GmshMesh {
  struct Line {
    std::array<std::size_t, 2> nodes;
    std::vector<std::string> groups;  ///< physical groups of its curve: names, else numbers
  };
  TriangleMesh mesh;
  std::vector<Line> lines;
  std::vector<std::string> groups;  ///< all physical groups of curves, sorted

  /// Whether the edge of these nodes is a line of a group.
  bool in_group(const std::array<std::size_t, 2>& edge, const std::string& group) const;
};

inline constexpr std::size_t most_mesh_bytes = 1'000'000'000;

/// Reads a mesh in Gmsh's format 4.1, ASCII (Gmsh reference manual, chapter "File formats"): linear
/// triangles in a plane of constant z, lines and points. A mesh whose triangles all run clockwise
/// is turned over. Throws InputError with line and column for a text that is not such a mesh, and
/// for one that `check` refuses.
GmshMesh read_gmsh(const std::string& file, const std::string& text);
GmshMesh read_gmsh_file(const std::string& file);

}  // namespace odeum::fem
