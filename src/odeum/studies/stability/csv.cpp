// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include "odeum/record/csv.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {
namespace {

std::string file_of(const StabilityRegion& region) {
  if (region.growth.empty()) return "";
  std::string name = region.library + "_" + region.solver + "_" + region.plane;
  std::replace(name.begin(), name.end(), '/', '_');
  return "stability/" + name + ".csv";
}

record::CsvRow& add_frame(record::CsvRow& row, const StabilityRegion& region) {
  return row.count(region.columns)
      .count(region.rows)
      .number(region.first_low)
      .number(region.first_high)
      .number(region.second_low)
      .number(region.second_high);
}

constexpr const char* frame_columns = "columns,rows,first_low,first_high,second_low,second_high";

}  // namespace

std::string growth_text(const StabilityRegion& region) {
  std::string text;
  const auto columns = static_cast<std::size_t>(region.columns);
  for (std::size_t i = 0; i < region.growth.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{:.4g}{}", region.growth[i],
                   (i + 1) % columns == 0 ? '\n' : ',');
  return text;
}

std::vector<float> read_growth(std::string_view text, const StabilityRegion& region) {
  const std::string copy(text);  // strtof wants an end
  const char* at = copy.c_str();
  std::vector<float> growth(static_cast<std::size_t>(region.columns) *
                            static_cast<std::size_t>(region.rows));
  for (float& value : growth) {
    char* end = nullptr;
    value = std::strtof(at, &end);
    if (end == at || (*end != ',' && *end != '\n'))
      throw std::runtime_error("malformed stability region");
    at = end + 1;
  }
  if (*at != '\0') throw std::runtime_error("malformed stability region");
  return growth;
}

void write_csv(const StabilityResult& result, const record::OutputFolder& folder) {
  record::CsvTable limits("library,solver,axis,limit,theory,difference,status,detail");
  for (const StabilityLimit& row : result.limits)
    limits.add(record::CsvRow()
                   .text(row.library)
                   .text(row.solver)
                   .text(row.axis)
                   .number(row.limit)
                   .number(row.theory)
                   .number(row.difference)
                   .text(row.status)
                   .text(row.detail));
  folder.write("stability_limits.csv", limits.text());

  record::CsvTable regions(
      fmt::format("library,solver,plane,status,detail,{},file", frame_columns));
  for (const StabilityRegion& region : result.regions) {
    record::CsvRow row;
    row.text(region.library).text(region.solver).text(region.plane);
    row.text(region.status).text(region.detail);
    const std::string file = file_of(region);
    regions.add(add_frame(row, region).text(file));
    if (file.empty()) continue;
    record::CsvTable data(fmt::format("plane,{}", frame_columns));
    record::CsvRow frame;
    frame.text(region.plane);
    data.add(add_frame(frame, region));
    folder.write(file, data.text() + growth_text(region));
  }
  folder.write("stability_regions.csv", regions.text());
}

}  // namespace odeum::study
