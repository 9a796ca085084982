// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/field_files.hpp"

namespace odeum::fem {

record::Records triangle_rows(const TriangleMesh& mesh, const std::vector<NodalField>& fields) {
  record::Records table{{"x1", "y1", "x2", "y2", "x3", "y3"}};
  for (const NodalField& field : fields)
    for (const char* node : {"1", "2", "3"}) table.columns.push_back(field.name + node);
  for (const auto& ids : mesh.triangles) {
    auto& row = table.rows.emplace_back();
    for (const std::size_t i : ids) row.insert(row.end(), {mesh.nodes[i].x, mesh.nodes[i].y});
    for (const NodalField& field : fields)
      for (const std::size_t i : ids) row.emplace_back(field.values[i]);
  }
  return table;
}

}  // namespace odeum::fem
