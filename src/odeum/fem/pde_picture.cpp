// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "odeum/core/enum_names.hpp"
#include "odeum/fem/second_order_pde.hpp"

namespace odeum::fem {
namespace {

constexpr double field = 480, left = 60, top = 34;

const char* colour_of(PdeType type) {
  return text_of_enumerator<PdeType::undefined>(
      type, {"#cfe3f5", "#7a3e9d", "#f8dfc4", "#dddddd", "#ffffff"});
}

std::string text(double x, double y, std::string_view anchor, std::string_view what) {
  std::string safe;
  for (const char c : what)
    safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return fmt::format("<text x=\"{:.4g}\" y=\"{:.4g}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     safe);
}

class Picture {
 public:
  explicit Picture(const PdeMap& map) : map_(map) {}

  /// Cells of the colour of their lower left node, joined along a row.
  std::string regions() const {
    std::string out;
    const double cell = field / static_cast<double>(map_.divisions);
    for (std::size_t j = 0; j < map_.divisions; ++j)
      for (std::size_t i = 0, end = 0; i < map_.divisions; i = end) {
        const PdeType type = map_.point(i, j).type;
        while (end < map_.divisions && map_.point(end, j).type == type) ++end;
        out += fmt::format(
            "<rect x=\"{:.5g}\" y=\"{:.5g}\" width=\"{:.5g}\" height=\"{:.5g}\" fill=\"{}\"/>\n",
            left + static_cast<double>(i) * cell, top + field - static_cast<double>(j + 1) * cell,
            static_cast<double>(end - i) * cell, cell, colour_of(type));
      }
    return out;
  }
  /// Strokes along the characteristic directions of some points.
  std::string directions() const {
    std::string out;
    const std::size_t stride = std::max<std::size_t>(1, map_.divisions / 24);
    const double half = 0.4 * field / 24;
    for (std::size_t j = stride / 2; j <= map_.divisions; j += stride)
      for (std::size_t i = stride / 2; i <= map_.divisions; i += stride)
        for (const auto& direction : map_.point(i, j).characteristics) {
          const auto [x, y] = at(map_.place(i, j));
          // In the picture's own proportions.
          double dx = direction[0] / (map_.region.x1 - map_.region.x0),
                 dy = -direction[1] / (map_.region.y1 - map_.region.y0);
          const double length = std::hypot(dx, dy);
          dx *= half / length, dy *= half / length;
          out += fmt::format("<path d=\"M{:.5g} {:.5g}L{:.5g} {:.5g}\"/>\n", x - dx, y - dy, x + dx,
                             y + dy);
        }
    return "<g stroke=\"#333333\" stroke-width=\"0.8\">\n" + out + "</g>\n";
  }
  std::string changes() const {
    std::string out;
    for (const auto& place : map_.changes) {
      const auto [x, y] = at(place);
      out += fmt::format("<circle cx=\"{:.5g}\" cy=\"{:.5g}\" r=\"1.6\"/>\n", x, y);
    }
    return "<g fill=\"#7a3e9d\">\n" + out + "</g>\n";
  }
  std::string axes(const std::string& second) const {
    const PdeRegion& r = map_.region;
    const double bottom = top + field + 18;
    return fmt::format(
               "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
               "stroke=\"#333333\"/>\n",
               left, top, field, field) +
           text(left, bottom, "middle", fmt::format("{:.4g}", r.x0)) +
           text(left + field, bottom, "middle", fmt::format("{:.4g}", r.x1)) +
           text(left + field / 2, bottom, "middle", "x") +
           text(left - 8, top + field, "end", fmt::format("{:.4g}", r.y0)) +
           text(left - 8, top + 10, "end", fmt::format("{:.4g}", r.y1)) +
           text(left - 8, top + field / 2, "end", second);
  }
  std::string legend() const {
    std::string out;
    double x = left;
    for (const PdeType type : {PdeType::elliptic, PdeType::hyperbolic, PdeType::parabolic,
                               PdeType::first_order, PdeType::undefined}) {
      const bool curve = type == PdeType::parabolic && !map_.changes.empty();
      if (!(map_.share(type) > 0) && !curve) continue;
      out += fmt::format(
                 "<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"12\" fill=\"{}\" "
                 "stroke=\"#333333\"/>\n",
                 x, top + field + 32, colour_of(type)) +
             text(x + 18, top + field + 43, "start", to_string(type));
      x += 110;
    }
    return out;
  }

 private:
  std::array<double, 2> at(const std::array<double, 2>& place) const {
    const PdeRegion& r = map_.region;
    return {left + field * (place[0] - r.x0) / (r.x1 - r.x0),
            top + field - field * (place[1] - r.y0) / (r.y1 - r.y0)};
  }
  const PdeMap& map_;
};

}  // namespace

std::string picture_of(const PdeMap& map, const std::string& title, const std::string& second) {
  const Picture picture(map);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" "
             "font-family=\"sans-serif\" font-size=\"13\">\n",
             left + field + 30, top + field + 60) +
         text(left, top - 12, "start", title) + picture.regions() + picture.directions() +
         picture.changes() + picture.axes(second) + picture.legend() + "</svg>\n";
}

}  // namespace odeum::fem
