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
       .options = {evolution_divisions},
       .figures = {{"rough_steps", rough_steps}, {"wave_divisions", wave_divisions}}},
      {.measure = measure_evolution});
}

}  // namespace odeum::study
