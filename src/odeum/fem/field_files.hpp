// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/fem/triangle_mesh.hpp"
#include "odeum/record/csv.hpp"

namespace odeum::fem {

/// A mesh with values at its nodes as a VTK file (legacy format 3.0, ASCII).
struct NodalField {
  std::string name;  ///< without spaces
  std::vector<double> values;
};
std::string vtk_of(const TriangleMesh& mesh, const std::string& title,
                   const std::vector<NodalField>& fields);

/// A row for each triangle, for a picture: x1, y1, x2, y2, x3, y3 of its nodes, and of each field
/// the values there, named as the field with 1, 2 and 3 behind.
record::Records triangle_rows(const TriangleMesh& mesh, const std::vector<NodalField>& fields);

}  // namespace odeum::fem
