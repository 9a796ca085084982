// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/stability/section.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {
namespace {

class Stability final : public StudyOf<StabilityResult> {
 public:
  Stability()
      : StudyOf({.name = "stability",
                 .help = "stability regions and limits, measured on the running code",
                 .place = 30,
                 .cases_help = "",
                 .options = {{.name = "plane",
                              .help = "lambda or oscillator; default: both",
                              .words = {"lambda", "oscillator"}},
                             {.name = "grid",
                              .help = "points along an axis",
                              .least = 8,
                              .most = 4096,
                              .whole = true},
                             {.name = "peer-grid",
                              .help = "the same for the solvers of other libraries",
                              .least = 8,
                              .most = 4096,
                              .whole = true}}}) {}

  std::vector<Options> report_runs(bool quick) const override {
    if (!quick) return {{}};
    return {{.own = {{"grid", "65"}, {"peer-grid", "17"}}}};
  }

  void write(const record::OutputFolder& folder) const override {
    StudyOf::write(folder);
    for (const StabilityRegion& region : result().regions)
      if (!region.growth.empty()) write_growth(region, folder);
  }

  std::string table() const override {
    return record::table_of(result().limits, {{"solver", "{library}/{solver}"},
                                              {"axis", "{axis}"},
                                              {"limit", "{limit:.7g}"},
                                              {"theory", "{theory:.7g}"},
                                              {"status", "{status}: {detail}"}})
        .text();
  }

  void section(report::Page& page) const override { add_section(page, result(), origin()); }

 protected:
  StabilityResult run(const Options& options, const Runner& runner) const override {
    return measure_stability(options, runner);
  }
};

}  // namespace

std::unique_ptr<Study> make_stability() { return std::make_unique<Stability>(); }

}  // namespace odeum::study
