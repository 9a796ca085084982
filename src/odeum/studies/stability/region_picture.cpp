// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "odeum/report/png.hpp"
#include "odeum/studies/stability/section.hpp"

namespace odeum::study {
namespace {

constexpr int width = 400;  // pixels: twice what is shown

// Growths are compared with these; what a solver rounds is no growth.
constexpr double levels[] = {0.25, 0.5, 0.75, 1.0000001, 1.25, 2};
constexpr std::size_t edge_level = 3;  // index of the boundary
// Beyond it growths are alike to every level; poles would else bend the lines beside them.
constexpr float largest_growth = 4;

enum Pixel : std::uint8_t { shade = 0, outside = 4, boundary = 5, line = 6, no_result = 7 };
const std::vector<report::Colour> palette{{0x21, 0x66, 0xac, 255},
                                          {0x4d, 0x88, 0xbf, 255},
                                          {0x7a, 0xaa, 0xd3, 255},
                                          {0xa6, 0xcb, 0xe6, 255},
                                          {0, 0, 0, 0},
                                          {0xd5, 0x5e, 0x00, 255},
                                          {0x90, 0x90, 0x90, 255},
                                          {0xb5, 0xa5, 0x8c, 255}};

/// Number of levels that the growth is above; `no_result` where it is not known.
using Class = std::uint8_t;

class Raster {
 public:
  explicit Raster(const StabilityRegion& region)
      : region_(region), height_(static_cast<int>(std::lround(width / aspect_of(region)))) {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width; ++x) classes_.push_back(class_at(x, y));
  }
  std::vector<std::uint8_t> pixels() const {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width; ++x) pixels.push_back(pixel_at(x, y));
    return pixels;
  }

 private:
  Class at(int x, int y) const { return classes_[static_cast<std::size_t>(y * width + x)]; }
  float growth(int column, int row) const {
    return std::min(region_.growth[static_cast<std::size_t>(row * region_.columns + column)],
                    largest_growth);
  }
  // Bilinear between the points of the grid; the first row of pixels is the upper edge.
  Class class_at(int x, int y) const {
    const double u = static_cast<double>(x) / (width - 1) * (region_.columns - 1),
                 v = static_cast<double>(height_ - 1 - y) / (height_ - 1) * (region_.rows - 1);
    const int i = std::min(static_cast<int>(u), region_.columns - 2),
              j = std::min(static_cast<int>(v), region_.rows - 2);
    const double p = u - i, q = v - j;
    const double value = (1 - q) * ((1 - p) * growth(i, j) + p * growth(i + 1, j)) +
                         q * ((1 - p) * growth(i, j + 1) + p * growth(i + 1, j + 1));
    if (std::isnan(value)) return no_result;
    return static_cast<Class>(std::upper_bound(std::begin(levels), std::end(levels), value) -
                              std::begin(levels));
  }
  static bool is_stable(Class c) { return c <= edge_level; }

  // A line where a pixel to the right or below is of another class; the boundary is thicker.
  std::uint8_t pixel_at(int x, int y) const {
    const Class here = at(x, y);
    if (here == no_result) return no_result;
    bool on_line = false;
    constexpr int reach = 2;
    for (int dy = 0; dy <= reach && y + dy < height_; ++dy)
      for (int dx = 0; dx <= reach && x + dx < width; ++dx) {
        const Class there = at(x + dx, y + dy);
        if (there == no_result || there == here) continue;
        if (is_stable(there) != is_stable(here)) return boundary;
        on_line |= dx + dy == 1 && !is_stable(here);
      }
    if (on_line) return line;
    return is_stable(here) ? here : Class{outside};
  }

  const StabilityRegion& region_;
  int height_;
  std::vector<Class> classes_;
};

}  // namespace

bool can_be_drawn(const StabilityRegion& region) {
  return region.columns > 1 && region.rows > 1 && region.first_low < region.first_high &&
         region.second_low < region.second_high &&
         region.growth.size() == static_cast<std::size_t>(region.columns) * region.rows &&
         std::any_of(region.growth.begin(), region.growth.end(),
                     [](float growth) { return std::isfinite(growth); });
}

double aspect_of(const StabilityRegion& region) {
  if (region.plane != "lambda") return 1.25;
  const double aspect =
      (region.first_high - region.first_low) / (region.second_high - region.second_low);
  return std::clamp(aspect, 0.5, 3.0);
}

std::string region_png(const StabilityRegion& region) {
  return report::png_of(width, Raster(region).pixels(), palette);
}

}  // namespace odeum::study
