// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/reduction/reduction.hpp"

namespace odeum::study {
std::unique_ptr<Study> make_reduction() {
  return make_study<ReductionResult>(
      {.name = "reduction",
       .help = "the order on Prothero and Robinson's problem as it becomes stiff",
       .place = 40,
       .cases_help = "",
       .figures = {{"end", reduction_end},
                   {"fewest_steps", reduction_fewest},
                   {"most_steps", reduction_most}}},
      {.measure = measure_reduction});
}

}  // namespace odeum::study
