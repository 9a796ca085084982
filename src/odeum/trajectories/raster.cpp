// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/raster.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/record/compress.hpp"

namespace odeum::trajectories {
namespace {

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>((number >> static_cast<unsigned>(shift)) & 0xffU);
  return bytes;
}

std::string chunk(const std::string& kind, const std::string& data) {
  const std::string checked = kind + data;
  const auto check = ::crc32_z(0, reinterpret_cast<const Bytef*>(checked.data()), checked.size());
  return big_endian(static_cast<std::uint32_t>(data.size())) + checked +
         big_endian(static_cast<std::uint32_t>(check));
}

}  // namespace

std::string png_of(std::size_t width, std::size_t height, const std::vector<std::uint8_t>& rgb) {
  std::string rows;
  rows.reserve(height * (3 * width + 1));
  for (std::size_t y = 0; y < height; ++y) {
    rows += '\0';  // no filter
    for (std::size_t k = 0; k < 3 * width; ++k) rows += static_cast<char>(rgb[3 * width * y + k]);
  }
  const std::string depth_and_kind("\x08\x02\0\0\0", 5);  // 8 bits of red, green and blue
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", big_endian(static_cast<std::uint32_t>(width)) +
                           big_endian(static_cast<std::uint32_t>(height)) + depth_and_kind) +
         chunk("IDAT", record::zlib_of(rows)) + chunk("IEND", "");
}

Picture::Picture(std::size_t width, std::size_t height, const Colour& background)
    : width_(fine * width),
      height_(fine * height),
      depth_(width_ * height_, std::numeric_limits<float>::infinity()),
      colour_(width_ * height_,
              {static_cast<float>(background[0]), static_cast<float>(background[1]),
               static_cast<float>(background[2])}) {}

/// Samples of a rectangle, in pixels: `inside(x, y, depth, brightness)` tells which are covered.
template <class Inside>
void Picture::fill(double x0, double x1, double y0, double y1, const Inside& inside) {
  const auto bound = [](double at, std::size_t most) {
    return static_cast<std::size_t>(
        std::clamp(std::floor(at * fine), 0., static_cast<double>(most)));
  };
  for (std::size_t row = bound(y0, height_), bottom = bound(y1 + 1, height_); row < bottom; ++row)
    for (std::size_t column = bound(x0, width_), right = bound(x1 + 1, width_); column < right;
         ++column) {
      Colour colour{};
      double depth = 0;
      const double x = (static_cast<double>(column) + 0.5) / fine,
                   y = (static_cast<double>(row) + 0.5) / fine;
      if (!inside(x, y, depth, colour)) continue;
      const std::size_t at = row * width_ + column;
      if (!(depth < static_cast<double>(depth_[at]))) continue;
      depth_[at] = static_cast<float>(depth);
      for (std::size_t k = 0; k < 3; ++k) colour_[at][k] = static_cast<float>(colour[k]);
    }
}

void Picture::triangle(const std::array<ScreenPoint, 3>& corners, const Colour& colour) {
  const auto& p = corners;
  const auto area = [](const ScreenPoint& a, const ScreenPoint& b, double x, double y) {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
  };
  const double whole = area(p[0], p[1], p[2][0], p[2][1]);
  if (!(std::abs(whole) > 0)) return;
  const auto [left, right] = std::minmax({p[0][0], p[1][0], p[2][0]});
  const auto [top, bottom] = std::minmax({p[0][1], p[1][1], p[2][1]});
  fill(left, right, top, bottom, [&](double x, double y, double& depth, Colour& found) {
    const double a = area(p[1], p[2], x, y) / whole, b = area(p[2], p[0], x, y) / whole,
                 c = 1 - a - b;
    found = colour;
    depth = a * p[0][2] + b * p[1][2] + c * p[2][2];
    return a >= 0 && b >= 0 && c >= 0;
  });
}

void Picture::line(const ScreenPoint& from, const ScreenPoint& to, const Colour& colour,
                   double width, double lift) {
  const double dx = to[0] - from[0], dy = to[1] - from[1], square = dx * dx + dy * dy;
  // The samples of a rectangle around it are looked at: of a long line around pieces.
  constexpr double longest = 24;
  if (square > longest * longest) {
    ScreenPoint middle{};
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (from[k] + to[k]) / 2;
    line(from, middle, colour, width, lift);
    return line(middle, to, colour, width, lift);
  }
  const double half = width / 2;
  const auto [left, right] = std::minmax(from[0], to[0]);
  const auto [top, bottom] = std::minmax(from[1], to[1]);
  fill(left - half, right + half, top - half, bottom + half,
       [&](double x, double y, double& depth, Colour& found) {
         const double along =
             square > 0 ? std::clamp(((x - from[0]) * dx + (y - from[1]) * dy) / square, 0., 1.)
                        : 0;
         found = colour;
         depth = from[2] + along * (to[2] - from[2]) - lift;
         return std::hypot(x - from[0] - along * dx, y - from[1] - along * dy) <= half;
       });
}

void Picture::ball(const ScreenPoint& centre, double radius, double depth_radius,
                   const Colour& colour) {
  fill(centre[0] - radius, centre[0] + radius, centre[1] - radius, centre[1] + radius,
       [&](double x, double y, double& depth, Colour& found) {
         const double off = std::hypot(x - centre[0], y - centre[1]) / radius;
         if (!(off <= 1)) return false;
         const double front = std::sqrt(1 - off * off);
         for (std::size_t k = 0; k < 3; ++k) found[k] = colour[k] * (0.45 + 0.55 * front);
         depth = centre[2] - front * depth_radius;
         return true;
       });
}

std::vector<std::uint8_t> Picture::rgb() const {
  const std::size_t width = width_ / fine, height = height_ / fine;
  std::vector<std::uint8_t> rgb(3 * width * height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t k = 0; k < 3; ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < fine * fine; ++i)
          sum +=
              static_cast<double>(colour_[(fine * y + i / fine) * width_ + fine * x + i % fine][k]);
        const double mean = std::clamp(sum / (fine * fine), 0., 1.);
        rgb[3 * (y * width + x) + k] = static_cast<std::uint8_t>(std::lround(255 * mean));
      }
  return rgb;
}

}  // namespace odeum::trajectories
