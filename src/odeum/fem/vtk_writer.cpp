// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "odeum/fem/field_files.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::fem {

std::string vtk_of(const TriangleMesh& mesh, const std::string& title,
                   const std::vector<NodalField>& fields) {
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\n{}\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      "POINTS {} double\n",
      shown(title), mesh.nodes.size());
  for (const Point p : mesh.nodes) text += fmt::format("{} {} 0\n", p.x, p.y);
  text += fmt::format("CELLS {} {}\n", mesh.triangles.size(), 4 * mesh.triangles.size());
  for (const auto& ids : mesh.triangles)
    text += fmt::format("3 {} {} {}\n", ids[0], ids[1], ids[2]);
  text += fmt::format("CELL_TYPES {}\n", mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) text += "5\n";
  text += fmt::format("POINT_DATA {}\n", mesh.nodes.size());
  for (const NodalField& field : fields) {
    text += fmt::format("SCALARS {} double 1\nLOOKUP_TABLE default\n", field.name);
    for (const double value : field.values) text += fmt::format("{}\n", value);
  }
  return text;
}

}  // namespace odeum::fem
