// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "odeum/core/parallel.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/report/report.hpp"
#include "odeum/studies/stability/outline.hpp"

namespace odeum::study {
namespace {

/// Writes the file of each region with a growth: a header and a line with schema, plane, columns,
/// rows, first_low, first_high, second_low, second_high; then growth_text.
void write_growths(const StabilityResult& result, const record::OutputFolder& folder,
                   unsigned jobs) {
  parallel_for(result.regions.size(), jobs, [&](std::size_t i) {
    const StabilityRegion& region = result.regions[i];
    if (region.growth.empty()) return;
    const record::Records data{
        {"plane", "columns", "rows", "first_low", "first_high", "second_low", "second_high"},
        {{region.plane, region.columns, region.rows, region.first_low, region.first_high,
          region.second_low, region.second_high}}};
    folder.write(region.growth_file(), data.csv() + growth_text(region));
  });
}

void show_outlines(report::Report& report, const StabilityResult& result) {
  report.data("regions", outlines_json(result.regions, report.jobs()));
}

}  // namespace

std::string StabilityRegion::growth_file() const {
  if (growth.empty()) return "";
  std::string name = library + "_" + solver + "_" + plane;
  std::ranges::replace(name, '/', '_');
  return "stability/" + name + ".csv.gz";
}

std::string growth_text(const StabilityRegion& region) {
  std::string text;
  const auto columns = static_cast<std::size_t>(region.columns);
  for (std::size_t i = 0; i < region.growth.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{:.4g}{}", region.growth[i],
                   (i + 1) % columns == 0 ? '\n' : ',');
  return text;
}

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
                   whole_number("grid", 8, 4096, "points along an axis"),
                   whole_number("peer-grid", 8, 4096,
                                "the same for the solvers of other libraries")},
       .quick_report = {{.own = {{"grid", "65"}, {"peer-grid", "17"}}}}},
      {.measure = measure_stability, .show_more = show_outlines, .write_more = write_growths});
}

}  // namespace odeum::study
