// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/proof/proof.hpp"
#include "odeum/studies/proof/section.hpp"

namespace odeum::study {
namespace {

class Proof final : public StudyOf<ProofResult> {
 public:
  Proof()
      : StudyOf({.name = "proof",
                 .help = "proofs of own methods: order conditions, stability, structure, mutants",
                 .place = 80,
                 .cases_help = "",
                 .quick_help = "a hundredth of the periods for the energy"}) {}

  std::vector<Options> report_runs(bool quick) const override {
    return quick ? std::vector<Options>() : std::vector<Options>(1);
  }

  std::string table() const override {
    return record::table_of(result().rows, {{"method", "{solver}"},
                                            {"claimed", "{claimed_order:d}"},
                                            {"conditions", "{conditions}"},
                                            {"code - R(z)", "{stability_difference:.0e}"},
                                            {"stability", "{stability}"},
                                            {"caught", "{caught:d}"},
                                            {"survived", "{survived:d}"},
                                            {"of mutants", "{mutants:d}"}})
        .text();
  }

  void section(report::Page& page) const override { add_section(page, result(), origin()); }

 protected:
  ProofResult run(const Options& options, const Runner& runner) const override {
    return prove(options, runner);
  }
};

}  // namespace

std::unique_ptr<Study> make_proof() { return std::make_unique<Proof>(); }

}  // namespace odeum::study
