// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/fem/triangle_mesh.hpp"

namespace odeum::fem {

/// A mesh with values at its nodes as a VTK file (legacy format 3.0, ASCII).
struct NodalField {
  std::string name;  ///< without spaces
  std::vector<double> values;
};
std::string vtk_of(const TriangleMesh& mesh, const std::string& title,
                   const std::vector<NodalField>& fields);

}  // namespace odeum::fem
