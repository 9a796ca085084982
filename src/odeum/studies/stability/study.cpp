// SPDX-License-Identifier: BSD-3-Clause
#include <thread>

#include "odeum/core/parallel.hpp"
#include "odeum/record/table.hpp"
#include "odeum/report/report.hpp"
#include "odeum/studies/stability/outline.hpp"

namespace odeum::study {
namespace {

std::string table(const StabilityResult& result) {
  std::string text;
  if (!result.steps.empty())
    text = record::table_of(result.steps,
                            {{"case", "{case}"},
                             {"solver", "{library}/{solver}"},
                             {"largest step", "{step:.4g}"},
                             {"by the eigenvalue", "{eigenvalue_re:.3g} {eigenvalue_im:+.3g}i"},
                             {"limit on its ray", "{limit:.5g}"},
                             {"status", "{status}: {detail}"}})
               .text();
  if (result.steps.empty() || !result.limits.empty())
    text += record::table_of(result.limits, {{"solver", "{library}/{solver}"},
                                             {"axis", "{axis}"},
                                             {"limit", "{limit:.7g}"},
                                             {"theory", "{theory:.7g}"},
                                             {"status", "{status}: {detail}"}})
                .text();
  return text;
}

void write_growths(const StabilityResult& result, const record::OutputFolder& folder) {
  parallel_for(result.regions.size(), std::thread::hardware_concurrency(), [&](std::size_t i) {
    if (!result.regions[i].growth.empty()) write_growth(result.regions[i], folder);
  });
}

void show_outlines(report::Report& report, const StabilityResult& result) {
  report.data("regions", outlines_json(result.regions));
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
      {.measure = measure_stability,
       .table = table,
       .show_more = show_outlines,
       .write_more = write_growths});
}

}  // namespace odeum::study
