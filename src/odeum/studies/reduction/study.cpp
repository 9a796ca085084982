// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/reduction/reduction.hpp"
#include "odeum/studies/reduction/section.hpp"

namespace odeum::study {
namespace {

class Reduction final : public StudyOf<ReductionResult> {
 public:
  Reduction()
      : StudyOf({.name = "reduction",
                 .help = "the order on Prothero and Robinson's problem as it becomes "
                         "stiff",
                 .place = 40,
                 .cases_help = ""}) {}
  std::vector<Options> report_runs(bool quick) const override {
    return quick ? std::vector<Options>() : std::vector<Options>(1);
  }
  std::string table() const override {
    return record::table_of(result().rows, {{"solver", "{library}/{solver}"},
                                            {"lambda", "{lambda:.0e}"},
                                            {"claimed", "{claimed_order:.3g}"},
                                            {"measured", "{measured_order:.3f}"},
                                            {"error", "{error_finest:.1e}"},
                                            {"verdict", "{verdict}: {reason}"}})
        .text();
  }

  void section(report::Page& page) const override { add_section(page, result(), origin()); }

 protected:
  ReductionResult run(const Options& options, const Runner& runner) const override {
    return measure_reduction(options, runner);
  }
};

}  // namespace

std::unique_ptr<Study> make_reduction() { return std::make_unique<Reduction>(); }

}  // namespace odeum::study
