// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/material/material.hpp"

namespace odeum::study {
// It takes a quarter of a minute: a quick report shows the rows of an earlier one.
std::unique_ptr<Study> make_material() {
  return make_study<MaterialResult>(
      {.name = "material",
       .help = "effective stiffness and damping of engines, cloth errors and costs",
       .place = 70,
       .cases_help = "",
       .figures = {{"stiffness", Specimen().stiffness},
                   {"damping", Specimen().damping},
                   {"mass", Specimen().mass},
                   {"masses", static_cast<double>(hanging_chain().masses)},
                   {"cloth_side", cloth_side},
                   {"timed_side", timed_cloth_side},
                   {"timed_time", timed_cloth_time},
                   {"timed_residual", timed_cloth_residual},
                   {"timed_margin", timed_cloth_margin}}},
      {.measure = measure_material});
}

}  // namespace odeum::study
