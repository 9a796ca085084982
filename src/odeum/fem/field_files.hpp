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

/// An <svg> of a mesh whose triangles have the colours of the means of their nodes' values, from
/// the lowest to the highest, which stand beside; a triangle tells its middle and its value when
/// pointed at. `values` by node; `title` is shown above and must be safe in markup.
std::string field_picture(const TriangleMesh& mesh, const std::vector<double>& values,
                          const std::string& title);

}  // namespace odeum::fem
