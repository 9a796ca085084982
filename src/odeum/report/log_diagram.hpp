// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "odeum/report/plots.hpp"

namespace odeum::report {

/// The axes of a diagram that we draw ourselves: both logarithmic, with room for their labels.
struct LogAxes {
  static constexpr double width = 640, height = 400;
  static constexpr double left = 62, right = 14, top = 10, bottom = 44;
  LogRange across, up;

  /// From values to coordinates of the picture.
  double x(double value) const;
  double y(double value) const;
};

/// A text in a picture; `text` is markup, escaped by whoever has it.
std::string svg_text(double x, double y, const char* anchor, const std::string& text);

/// 10 with the exponent raised, as markup of a text.
std::string power_of_ten(int exponent);

/// Words for a value beside a tick of the axis across.
using TickLabel = std::function<std::string(double value)>;

/// The <svg> of class "plot speed" (`description` is for those who cannot see it), its grid, the
/// labels of the ticks and the two axes. Ticks are at powers of ten; across, where these are few,
/// at 2 and 5 of each as well.
std::string open_diagram(const LogAxes& axes, const char* description, const TickLabel& across);

/// What stands beside the axes, and the end of the <svg>.
std::string close_diagram(const char* across, const char* up);

}  // namespace odeum::report
