// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/limits/limits.hpp"
#include "odeum/studies/limits/section.hpp"

namespace odeum::study {
namespace {

class Limits final : public StudyOf<LimitsResult> {
 public:
  Limits()
      : StudyOf(
            {.name = "limits",
             .help = "the largest stable step on stiff cases, and the prediction of the spectrum",
             .place = 50,
             .cases_help = "cases, with * and ?; default: the stiff ones"}) {}

  /// Own solvers on every stiff case; peers on a decay, a relaxation and a vibration.
  std::vector<Options> report_runs(bool quick) const override {
    if (quick) return {};
    return {{.solvers = {"odeum/*"}},
            {.cases = {"prothero_robinson_1e3_smooth", "vdp_mu1000", "stiff_chain2_k1e4"},
             .solvers = {"!odeum/*"}}};
  }

  std::string table() const override {
    return record::table_of(result().rows,
                            {{"case", "{case}"},
                             {"solver", "{library}/{solver}"},
                             {"measured", "{largest_stable_step:.4g}"},
                             {"predicted", "{predicted_step:.4g}"},
                             {"eigenvalue", "{eigenvalue_re:.3g} {eigenvalue_im:+.3g}i"},
                             {"remark", "{status}: {detail}"}})
        .text();
  }

  void section(report::Page& page) const override { add_section(page, result(), origin()); }

 protected:
  LimitsResult run(const Options& options, const Runner& runner) const override {
    return measure_limits(options, runner);
  }
};

}  // namespace

std::unique_ptr<Study> make_limits() { return std::make_unique<Limits>(); }

}  // namespace odeum::study
