// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/material/material.hpp"

namespace odeum::study {
// It takes several seconds: a quick report shows the rows of an earlier one.
std::unique_ptr<Study> make_material() {
  return make_study<MaterialResult>(
      {.name = "material",
       .help = "effective stiffness and damping of springs under engines",
       .place = 70,
       .cases_help = "",
       .figures = {{"stiffness", Specimen().stiffness},
                   {"damping", Specimen().damping},
                   {"mass", Specimen().mass},
                   {"masses", static_cast<double>(hanging_chain().masses)}}},
      {.measure = measure_material});
}

}  // namespace odeum::study
