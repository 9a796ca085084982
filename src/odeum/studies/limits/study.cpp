// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/limits/limits.hpp"

namespace odeum::study {
// A report runs own solvers on every stiff case; peers on a decay, a relaxation and a vibration.
std::unique_ptr<Study> make_limits() {
  return make_study<LimitsResult>(
      {.name = "limits",
       .help = "the largest stable step on stiff cases, and the prediction of the spectrum",
       .place = 50,
       .cases_help = "cases, with * and ?; default: the stiff ones",
       .report = {{.solvers = {"odeum/*"}},
                  {.cases = {"prothero_robinson_1e3_smooth", "vdp_mu1000", "stiff_chain2_k1e4"},
                   .solvers = {"!odeum/*"}}}},
      {.measure = measure_limits});
}

}  // namespace odeum::study
