// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "odeum/record/csv.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {

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

void write_growth(const StabilityRegion& region, const record::OutputFolder& folder) {
  const record::Records data{
      {"plane", "columns", "rows", "first_low", "first_high", "second_low", "second_high"},
      {{region.plane, region.columns, region.rows, region.first_low, region.first_high,
        region.second_low, region.second_high}}};
  folder.write(region.growth_file(), data.csv() + growth_text(region));
}

}  // namespace odeum::study
