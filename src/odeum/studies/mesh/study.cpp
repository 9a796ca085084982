// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/mesh/rows.hpp"

namespace odeum::study {
std::unique_ptr<Study> make_mesh() {
  return make_study<MeshResult>(
      {.name = "mesh",
       .help = "one square sheet at meshes of 6 x 6 to 96 x 96, and how to scale springs",
       .place = 75,
       .cases_help = "",
       .options = {whole_number("most", 6, 192,
                                "particles along an edge of the finest; default: 96")},
       .figures = {{"edge", sheet_edge}, {"mass", sheet_mass}},
       .report = {{.own = {{"most", "24"}}}}},
      {.measure = measure_mesh});
}

}  // namespace odeum::study
