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
       .options = {{.name = "most",
                    .help = "divisions of the finest mesh, of which the largest power of "
                            "two is taken; default: 128",
                    .least = 16,
                    .most = 512,
                    .whole = true}},
       .figures = {{"rough_steps", rough_steps}, {"wave_divisions", wave_divisions}}},
      {.measure = measure_evolution});
}

}  // namespace odeum::study
