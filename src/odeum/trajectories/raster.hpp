// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace odeum::trajectories {

/// Red, green and blue, 0 to 1.
using Colour = std::array<double, 3>;
/// A point of a picture: x to the right and y down, in pixels, and the depth, which grows away from
/// the eye.
using ScreenPoint = std::array<double, 3>;

/// A PNG file of 8 bits a colour from rows of red, green and blue.
std::string png_of(std::size_t width, std::size_t height, const std::vector<std::uint8_t>& rgb);

/// A picture with depth: the nearer covers the farther, in any order of drawing. Each pixel is the
/// mean of `fine` x `fine` samples.
class Picture {
 public:
  Picture(std::size_t width, std::size_t height, const Colour& background);

  void triangle(const std::array<ScreenPoint, 3>& corners, const Colour& colour);
  /// `width` in pixels. It stands before what is `lift` nearer than it, at most.
  void line(const ScreenPoint& from, const ScreenPoint& to, const Colour& colour, double width,
            double lift = 0);
  /// A ball, shaded towards its rim; `depth_radius`: its radius as a depth.
  void ball(const ScreenPoint& centre, double radius, double depth_radius, const Colour& colour);

  /// Rows of red, green and blue.
  std::vector<std::uint8_t> rgb() const;
  /// The bytes of a PNG file.
  std::string png() const { return png_of(width_ / fine, height_ / fine, rgb()); }

 private:
  static constexpr std::size_t fine = 2;
  template <class Inside>
  void fill(double x0, double x1, double y0, double y1, const Inside& inside);

  std::size_t width_, height_;  ///< in samples
  std::vector<float> depth_;
  std::vector<std::array<float, 3>> colour_;
};

}  // namespace odeum::trajectories
