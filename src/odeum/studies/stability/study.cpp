// SPDX-License-Identifier: BSD-3-Clause
#include <thread>

#include "odeum/core/parallel.hpp"
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
                 .cases_help = "the steps that the regions allow on these cases, with * and ?; "
                               "default: the regions themselves",
                 .on_cases = false,
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
    const std::vector<StabilityRegion>& regions = result().regions;
    parallel_for(regions.size(), std::thread::hardware_concurrency(), [&](std::size_t i) {
      if (!regions[i].growth.empty()) write_growth(regions[i], folder);
    });
  }

  std::string table() const override {
    const StabilityResult& all = result();
    std::string text;
    if (!all.steps.empty())
      text = record::table_of(all.steps,
                              {{"case", "{case}"},
                               {"solver", "{library}/{solver}"},
                               {"largest step", "{step:.4g}"},
                               {"by the eigenvalue", "{eigenvalue_re:.3g} {eigenvalue_im:+.3g}i"},
                               {"limit on its ray", "{limit:.5g}"},
                               {"status", "{status}: {detail}"}})
                 .text();
    if (all.steps.empty() || !all.limits.empty())
      text += record::table_of(all.limits, {{"solver", "{library}/{solver}"},
                                            {"axis", "{axis}"},
                                            {"limit", "{limit:.7g}"},
                                            {"theory", "{theory:.7g}"},
                                            {"status", "{status}: {detail}"}})
                  .text();
    return text;
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
