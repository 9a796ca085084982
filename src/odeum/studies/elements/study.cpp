// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/elements/rows.hpp"

namespace odeum::study {
std::unique_ptr<Study> make_elements() {
  return make_study<ElementsResult>(
      {.name = "elements",
       .help = "linear finite elements: error against mesh size, and linear solvers",
       .place = 78,
       .cases_help = "",
       .options = {elements_divisions}},
      {.measure = measure_elements});
}

}  // namespace odeum::study
