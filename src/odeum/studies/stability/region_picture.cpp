// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/plots.hpp"

namespace odeum::report {
namespace {

constexpr int most_points = 129;  // along an axis; finer grids would only cost time at this size

constexpr float no_result = -1, largest_growth = 1e6F;

// Indices of about `most_points` of `count` grid lines, evenly spread, both ends among them.
std::vector<int> thinned(int count) {
  const int kept = std::min(count, most_points);
  std::vector<int> indices;
  for (int i = 0; i < kept; ++i)
    indices.push_back(kept == 1 ? 0
                                : static_cast<int>(std::lround(static_cast<double>(i) *
                                                               (count - 1) / (kept - 1))));
  return indices;
}

float coordinate(double low, double high, int index, int count) {
  return static_cast<float>(count > 1 ? low + (high - low) * index / (count - 1) : low);
}

// gnuplot's binary matrix: the number of columns and their coordinates, then each row behind its
// own coordinate.
std::vector<float> binary_matrix(const study::StabilityRegion& region) {
  const std::vector<int> columns = thinned(region.columns), rows = thinned(region.rows);
  std::vector<float> matrix{static_cast<float>(columns.size())};
  for (const int i : columns)
    matrix.push_back(coordinate(region.first_low, region.first_high, i, region.columns));
  for (const int j : rows) {
    matrix.push_back(coordinate(region.second_low, region.second_high, j, region.rows));
    for (const int i : columns) {
      const float growth = region.growth[static_cast<std::size_t>(j) * region.columns + i];
      matrix.push_back(std::isnan(growth) ? no_result : std::min(growth, largest_growth));
    }
  }
  return matrix;
}

}  // namespace

Picture draw(const study::StabilityRegion& region) {
  Picture picture{.kind = Picture::Kind::png, .width = 230};
  const double aspect =
      (region.second_high - region.second_low) / (region.first_high - region.first_low);
  const bool lambda = region.plane == "lambda";
  picture.height = lambda ? static_cast<int>(std::clamp(206 * aspect + 24, 80.0, 400.0)) : 190;
  picture.matrix = binary_matrix(region);
  const double tick = lambda ? 2 : 1;
  // Greys that can be read on a light and on a dark page. Above 1 on the colour axis: no result.
  picture.commands = fmt::format(
      "unset key\nunset colorbox\nset border lc rgb '#808080'\n"
      "set tics textcolor rgb '#808080' out nomirror scale 0.5\n"
      "set xtics {4} offset 0,0.4\nset ytics {4} offset 0.6,0\n"
      "set lmargin 3.4\nset rmargin 0.6\nset tmargin 0.5\nset bmargin 1.6\n"
      "set xrange [{0}:{1}]\nset yrange [{2}:{3}]\nset cbrange [0:1.25]\n"
      "set palette maxcolors 5 defined (0 '#2166ac', 1 '#a6cbe6', 1.001 '#b5a58c', 1.25 "
      "'#b5a58c')\n"
      "unset surface\nset contour base\nset cntrparam levels discrete 1\n"
      "set table $edge\nsplot matrix binary matrix using 1:2:($3 < 0 ? NaN : $3)\nunset table\n"
      "set cntrparam levels discrete 1.25, 2\n"
      "set table $levels\nsplot matrix binary matrix using 1:2:($3 < 0 ? NaN : $3)\nunset table\n"
      "unset contour\n"
      "plot matrix binary matrix using 1:2:($3 < 0 ? 1.2 : $3 <= 1.0000001 ? $3 : NaN) with image, "
      "$levels with lines lc rgb '#909090' lw 0.6, $edge with lines lc rgb '#d55e00' lw 1.6\n",
      region.first_low, region.first_high, region.second_low, region.second_high, tick);
  return picture;
}

}  // namespace odeum::report
