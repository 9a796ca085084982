// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/proof/proof.hpp"

namespace odeum::study {
namespace {

std::string table(const ProofResult& result) {
  return record::table_of(result.rows, {{"method", "{solver}"},
                                        {"claimed", "{claimed_order:d}"},
                                        {"conditions", "{conditions}"},
                                        {"code - R(z)", "{stability_difference:.0e}"},
                                        {"stability", "{stability}"},
                                        {"caught", "{caught:d}"},
                                        {"survived", "{survived:d}"},
                                        {"of mutants", "{mutants:d}"}})
      .text();
}

}  // namespace

std::unique_ptr<Study> make_proof() {
  return make_study<ProofResult>(
      {.name = "proof",
       .help = "proofs of own methods: order conditions, stability, structure, mutants",
       .place = 80,
       .cases_help = "",
       .quick_help = "a hundredth of the periods for the energy"},
      {.measure = prove, .table = table});
}

}  // namespace odeum::study
