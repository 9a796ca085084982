// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/field_files.hpp"

namespace odeum::fem {

record::CsvTable triangle_rows(const TriangleMesh& mesh, const std::vector<NodalField>& fields) {
  std::string columns = "x1,y1,x2,y2,x3,y3";
  for (const NodalField& field : fields)
    for (const char* node : {"1", "2", "3"}) columns += "," + field.name + node;
  record::CsvTable table(columns, true);
  for (const auto& ids : mesh.triangles) {
    record::CsvRow row;
    for (const std::size_t i : ids) row.number(mesh.nodes[i].x).number(mesh.nodes[i].y);
    for (const NodalField& field : fields)
      for (const std::size_t i : ids) row.number(field.values[i]);
    table.add(row);
  }
  return table;
}

}  // namespace odeum::fem
