// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/mesh/rows.hpp"

namespace odeum::study {
std::unique_ptr<Study> make_mesh() {
  return make_study<MeshResult>(
      {.name = "mesh",
       .help = "one square sheet at meshes from coarse to fine, and how to scale springs",
       .place = 75,
       .cases_help = "",
       .options = {finest_mesh},
       .figures = {{"edge", sheet_edge}, {"mass", sheet_mass}},
       .report = {{.own = {{"most", "24"}}}}},
      {.measure = measure_mesh});
}

}  // namespace odeum::study
