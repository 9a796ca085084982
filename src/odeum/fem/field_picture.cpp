// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/fem/field_files.hpp"

namespace odeum::fem {
namespace {

/// From dark blue to yellow, of rising lightness, so that it reads without colours too.
std::string colour_of(double part) {
  constexpr double stops[][3] = {
      {68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
  const double at = 4 * std::clamp(part, 0., 1.);
  const auto k = std::min<std::size_t>(3, static_cast<std::size_t>(at));
  const double s = at - static_cast<double>(k);
  int rgb[3];
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<int>(std::lround((1 - s) * stops[k][c] + s * stops[k + 1][c]));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

}  // namespace

std::string field_picture(const TriangleMesh& mesh, const std::vector<double>& values,
                          const std::string& title) {
  constexpr double size = 320, top = 26, bar = 14;
  Point low = mesh.nodes.front(), high = low;
  for (const Point p : mesh.nodes) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double scale = size / std::max(high.x - low.x, high.y - low.y);
  const double width = scale * (high.x - low.x), height = scale * (high.y - low.y);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double range = *most > *least ? *most - *least : 1;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"field\" viewBox=\"0 0 {:.5g} {:.5g}\" "
      "width=\"{:.5g}\" "
      "font-family=\"sans-serif\" font-size=\"12\" fill=\"currentColor\" role=\"img\">\n"
      "<text x=\"4\" y=\"16\">{}</text>\n<g stroke=\"#000000\" stroke-opacity=\"0.35\" "
      "stroke-width=\"0.4\">\n",
      width + 100, height + top + 6, width + 100, title);
  for (const auto& ids : mesh.triangles) {
    Point middle;
    double mean = 0;
    std::string path;
    for (const std::size_t i : ids) {
      const Point p = mesh.nodes[i];
      middle.x += p.x / 3, middle.y += p.y / 3, mean += values[i] / 3;
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', 4 + scale * (p.x - low.x),
                          top + scale * (high.y - p.y));
    }
    svg +=
        fmt::format("<path d=\"{}Z\" fill=\"{}\"><title>({:.3g}, {:.3g}): {:.4g}</title></path>\n",
                    path, colour_of((mean - *least) / range), middle.x, middle.y, mean);
  }
  svg += "</g>\n";
  constexpr int steps = 32;
  for (int k = 0; k < steps; ++k)
    svg += fmt::format(
        "<rect x=\"{:.5g}\" y=\"{:.5g}\" width=\"{}\" height=\"{:.5g}\" fill=\"{}\"/>\n",
        width + 14, top + height * (steps - 1 - k) / steps, bar, height / steps + 0.5,
        colour_of((k + 0.5) / steps));
  return svg + fmt::format(
                   "<text x=\"{0:.5g}\" y=\"{1:.5g}\">{2:.3g}</text>\n"
                   "<text x=\"{0:.5g}\" y=\"{3:.5g}\">{4:.3g}</text>\n</svg>\n",
                   width + 18 + bar, top + 10, *most, top + height, *least);
}

}  // namespace odeum::fem
