// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/stability/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "odeum/core/parallel.hpp"
#include "odeum/report/text.hpp"

namespace odeum::study {
namespace {

// Rounding of a growth of 1 stays below it.
constexpr double no_growth = 1.0001;
// The levels of the shades of damping and the lines of growth.
constexpr double other_levels[] = {0.25, 0.5, 0.75, 1.25, 2};
// What is compared with the level: growths far beyond it would bend the line.
constexpr double largest = 4;

/// The grid with a frame of large growths around it, which closes every loop.
class Grid {
 public:
  explicit Grid(const StabilityRegion& region) : region_(region) {}
  int columns() const { return region_.columns + 2; }
  int rows() const { return region_.rows + 2; }
  double growth(int i, int j) const {
    if (i == 0 || j == 0 || i == columns() - 1 || j == rows() - 1) return largest;
    const float g = region_.growth[static_cast<std::size_t>((j - 1) * region_.columns + i - 1)];
    return std::isnan(g) ? largest : std::min<double>(g, largest);
  }
  // The frame lies on the edges of the plane.
  double x(double i) const {
    return between(region_.first_low, region_.first_high, (i - 1) / (region_.columns - 1));
  }
  double y(double j) const {
    return between(region_.second_low, region_.second_high, (j - 1) / (region_.rows - 1));
  }

 private:
  static double between(double low, double high, double part) {
    return low + (high - low) * std::clamp(part, 0.0, 1.0);
  }
  const StabilityRegion& region_;
};

/// An edge of the grid: of its point (i, j) to the right (0) or upwards (1).
using Edge = std::tuple<int, int, int>;

class March {
 public:
  March(const Grid& grid, double level) : grid_(grid), level_(level) {
    for (int j = 0; j + 1 < grid.rows(); ++j)
      for (int i = 0; i + 1 < grid.columns(); ++i) cell(i, j);
  }
  std::vector<Loop> loops() {
    std::vector<Loop> all;
    while (!next_.empty()) {
      Loop loop;
      const Edge first = next_.begin()->first;
      Edge edge = first;
      do {
        loop.push_back(point(edge));
        const auto found = next_.find(edge);
        const Edge after = found->second;
        next_.erase(found);
        edge = after;
      } while (edge != first && next_.contains(edge));
      if (loop.size() > 2) all.push_back(std::move(loop));
    }
    return all;
  }

 private:
  bool inside(int i, int j) const { return grid_.growth(i, j) <= level_; }

  // Each piece of the outline leads from the edge where, walking around the cell against the clock,
  // the inside begins, to the edge where it ends: so the pieces of neighbouring cells join. In a
  // saddle the two insides stay apart.
  void cell(int i, int j) {
    const bool corner[] = {inside(i, j), inside(i + 1, j), inside(i + 1, j + 1), inside(i, j + 1)};
    const Edge side[] = {{i, j, 0}, {i + 1, j, 1}, {i, j + 1, 0}, {i, j, 1}};
    for (int k = 0; k < 4; ++k) {
      if (corner[k] || !corner[(k + 1) % 4]) continue;  // the inside begins on side k
      int end = (k + 1) % 4;
      while (corner[(end + 1) % 4]) end = (end + 1) % 4;
      next_[side[end]] = side[k];
    }
  }

  Loop::value_type point(const Edge& edge) const {
    const auto [i, j, upwards] = edge;
    const double a = grid_.growth(i, j),
                 b = grid_.growth(i + (upwards ? 0 : 1), j + (upwards ? 1 : 0));
    const double part = (level_ - a) / (b - a);
    return upwards ? Loop::value_type{grid_.x(i), grid_.y(j + part)}
                   : Loop::value_type{grid_.x(i + part), grid_.y(j)};
  }

  const Grid& grid_;
  double level_;
  std::map<Edge, Edge> next_;
};

// Points that lie on the line through their neighbours, to a thousandth of the plane, are left out.
Loop simplified(const Loop& loop, double width) {
  Loop kept;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const auto& next = loop[(k + 1) % loop.size()];
    if (!kept.empty()) {
      const auto& last = kept.back();
      const double dx = next.first - last.first, dy = next.second - last.second;
      const double length = std::hypot(dx, dy);
      const double away =
          std::abs(dx * (loop[k].second - last.second) - dy * (loop[k].first - last.first));
      if (length > 0 && away < 2e-4 * width * length && length < 0.1 * width) continue;
    }
    kept.push_back(loop[k]);
  }
  return kept;
}

nlohmann::ordered_json json_of(const StabilityRegion& region, double level) {
  nlohmann::ordered_json loops = nlohmann::ordered_json::array();
  for (const Loop& loop : outline(region, level)) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const auto& [x, y] : simplified(loop, region.first_high - region.first_low))
      points.insert(points.end(), {std::round(x * 1e4) / 1e4, std::round(y * 1e4) / 1e4});
    loops.push_back(std::move(points));
  }
  return loops;
}

}  // namespace

std::vector<Loop> outline(const StabilityRegion& region, double level) {
  if (region.columns < 2 || region.rows < 2 ||
      region.growth.size() != static_cast<std::size_t>(region.columns * region.rows))
    return {};
  const Grid grid(region);
  return March(grid, level).loops();
}

std::string outlines_json(const std::vector<StabilityRegion>& regions, unsigned jobs) {
  std::vector<nlohmann::ordered_json> list(regions.size());
  parallel_for(regions.size(), jobs, [&](std::size_t i) {
    const StabilityRegion& region = regions[i];
    nlohmann::ordered_json others = nlohmann::ordered_json::object();
    for (const double level : other_levels)
      others[fmt::format("{}", level)] = json_of(region, level);
    list[i] = {
        {"solver", report::plain(region.library + "/" + region.solver)},
        {"plane", report::plain(region.plane)},
        {"missing", report::plain(region.growth.empty() ? region.detail : "")},
        {"box", {region.first_low, region.first_high, region.second_low, region.second_high}},
        {"cell", (region.first_high - region.first_low) / std::max(1, region.columns - 1)},
        {"loops", json_of(region, no_growth)},
        {"others", others}};
  });
  return nlohmann::ordered_json(list).dump(-1, ' ', false,
                                           nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace odeum::study
