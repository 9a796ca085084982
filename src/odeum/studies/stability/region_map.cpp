// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/stability/region_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "odeum/core/parallel.hpp"

namespace odeum::study {
namespace {

/// The coordinate of a grid point, exact at both edges and in the middle of an odd grid.
double coordinate(double low, double high, int i, int count) {
  const double fraction = static_cast<double>(i) / (count - 1);
  return low * (1 - fraction) + high * fraction;
}

/// Calls fill(second, row) for each row to be solved; returns their number.
template <class Fill>
int fill_rows(StabilityRegion& region, bool mirrored, Fill&& fill) {
  const auto columns = static_cast<std::size_t>(region.columns);
  region.growth.resize(columns * static_cast<std::size_t>(region.rows));
  const auto row = [&](int j) {
    return region.growth.data() + static_cast<std::size_t>(j) * columns;
  };
  const int first = mirrored ? region.rows / 2 : 0;
  for (int j = first; j < region.rows; ++j) {
    if (interrupted) throw Interrupted();
    fill(coordinate(region.second_low, region.second_high, j, region.rows), row(j));
    const int mirror = region.rows - 1 - j;
    if (mirrored && mirror != j) std::copy_n(row(j), columns, row(mirror));
  }
  return region.rows - first;
}

}  // namespace

void map_region(GrowthMeter& meter, bool mirrored, StabilityRegion& region) {
  int failures = 0;
  std::string status, detail;  // of the first failure
  const int rows = fill_rows(region, mirrored, [&](double second, float* row) {
    for (int i = 0; i < region.columns; ++i) {
      const double first = coordinate(region.first_low, region.first_high, i, region.columns);
      const judge::Growth growth = meter.measure(first, second);
      row[i] = static_cast<float>(std::exp(growth.log_per_step));
      if (growth.failed() && failures++ == 0) {
        status = to_string(meter.status());
        detail = meter.failure();
      }
    }
  });
  const int points = rows * region.columns;
  region.status = failures == points ? status : to_string(Status::ok);
  if (failures > 0)
    region.detail =
        fmt::format("no result at {} of {} points; the first: {}", failures, points, detail);
}

void map_region_in_lanes(LaneRunner runner, StabilityRegion& region) {
  constexpr unsigned steps = 16;  // all equal: a one-step method multiplies y by R(z)
  const auto count = static_cast<std::size_t>(region.columns);
  std::vector<double> re(count), im(count), squared(count);
  for (std::size_t i = 0; i < count; ++i)
    re[i] = coordinate(region.first_low, region.first_high, static_cast<int>(i), region.columns);
  fill_rows(region, true, [&](double second, float* row) {
    std::fill(im.begin(), im.end(), second);
    runner(re.data(), im.data(), count, steps, squared.data());
    for (std::size_t i = 0; i < count; ++i)
      row[i] = static_cast<float>(std::pow(squared[i], 1.0 / (2 * steps)));
  });
  region.status = to_string(Status::ok);
}

}  // namespace odeum::study
