// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/log_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace odeum::report {
namespace {

std::string ticks_across(const LogAxes& axes, const TickLabel& label) {
  std::string lines, labels;
  const LogRange& range = axes.across;
  const double decades = std::log10(range.high / range.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 10)));
  const int first = static_cast<int>(std::floor(std::log10(range.low)));
  for (int k = first; std::pow(10.0, k) <= range.high; ++k)
    for (const double m : {1.0, 2.0, 5.0}) {
      const double value = m * std::pow(10.0, k);
      if (value < range.low || value > range.high || (m > 1 && decades >= 2) || k % every != 0)
        continue;
      lines += fmt::format("M{:.1f} {}V{}", axes.x(value), LogAxes::top,
                           LogAxes::height - LogAxes::bottom);
      labels +=
          svg_text(axes.x(value), LogAxes::height - LogAxes::bottom + 15, "middle", label(value));
    }
  return "<path class=\"grid\" d=\"" + lines + "\"/>" + labels;
}

std::string ticks_up(const LogAxes& axes) {
  std::string lines, labels;
  const double decades = std::log10(axes.up.high / axes.up.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 9)));
  const int first = static_cast<int>(std::ceil(std::log10(axes.up.low)));
  for (int k = first; std::pow(10.0, k) <= axes.up.high; ++k) {
    if (k % every != 0) continue;
    const double y = axes.y(std::pow(10.0, k));
    lines += fmt::format("M{} {:.1f}H{}", LogAxes::left, y, LogAxes::width - LogAxes::right);
    labels += svg_text(LogAxes::left - 6, y + 4, "end", power_of_ten(k));
  }
  return "<path class=\"grid\" d=\"" + lines + "\"/>" + labels;
}

}  // namespace

double LogAxes::x(double value) const {
  return left +
         (width - left - right) * std::log(value / across.low) / std::log(across.high / across.low);
}

double LogAxes::y(double value) const {
  return top + (height - top - bottom) * std::log(up.high / value) / std::log(up.high / up.low);
}

std::string svg_text(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", x, y, anchor,
                     text);
}

std::string power_of_ten(int exponent) {
  return fmt::format("10<tspan dy=\"-5\" font-size=\"9\">{}</tspan>", exponent);
}

std::string open_diagram(const LogAxes& axes, const char* description, const TickLabel& across) {
  return fmt::format(
             "<svg class=\"plot speed\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
             LogAxes::width, LogAxes::height, description) +
         ticks_across(axes, across) + ticks_up(axes) +
         fmt::format("<path d=\"M{0} {1}V{2}H{3}\"/>", LogAxes::left, LogAxes::top,
                     LogAxes::height - LogAxes::bottom, LogAxes::width - LogAxes::right);
}

std::string close_diagram(const char* across, const char* up) {
  const double middle_up = (LogAxes::top + LogAxes::height - LogAxes::bottom) / 2;
  return svg_text((LogAxes::left + LogAxes::width - LogAxes::right) / 2, LogAxes::height - 8,
                  "middle", across) +
         fmt::format(
             "<text transform=\"translate(14,{}) rotate(-90)\" text-anchor=\"middle\">{}</text>"
             "</svg>",
             middle_up, up);
}

}  // namespace odeum::report
