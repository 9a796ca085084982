// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/proof/proof.hpp"

namespace odeum::study {
std::unique_ptr<Study> make_proof() {
  return make_study<ProofResult>(
      {.name = "proof",
       .help = "proofs of own methods: order conditions, stability, structure, mutants",
       .place = 80,
       .cases_help = "",
       .quick_help = "a hundredth of the periods for the energy"},
      {.measure = prove});
}

}  // namespace odeum::study
