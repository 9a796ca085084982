// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/evolution/rows.hpp"

namespace odeum::study {
std::unique_ptr<Study> make_evolution() {
  return make_study<EvolutionResult>(
      {.name = "evolution",
       .help = "heat and waves by finite elements: errors of mesh and of steps apart, and "
               "the cheapest pair of both",
       .place = 79,
       .cases_help = "",
       .options = {whole_number("most", 16, 512,
                                "divisions of the finest mesh, of which the largest power of two "
                                "is taken; default: 128")},
       .figures = {{"rough_steps", rough_steps}, {"wave_divisions", wave_divisions}}},
      {.measure = measure_evolution});
}

}  // namespace odeum::study
