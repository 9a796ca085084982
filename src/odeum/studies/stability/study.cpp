// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/parallel.hpp"
#include "odeum/report/report.hpp"
#include "odeum/studies/stability/outline.hpp"

namespace odeum::study {
namespace {

void write_growths(const StabilityResult& result, const record::OutputFolder& folder,
                   unsigned jobs) {
  parallel_for(result.regions.size(), jobs, [&](std::size_t i) {
    if (!result.regions[i].growth.empty()) write_growth(result.regions[i], folder);
  });
}

void show_outlines(report::Report& report, const StabilityResult& result) {
  report.data("regions", outlines_json(result.regions, report.jobs()));
}

}  // namespace

std::unique_ptr<Study> make_stability() {
  return make_study<StabilityResult>(
      {.name = "stability",
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
                    .whole = true}},
       .quick_report = {{.own = {{"grid", "65"}, {"peer-grid", "17"}}}}},
      {.measure = measure_stability, .show_more = show_outlines, .write_more = write_growths});
}

}  // namespace odeum::study
