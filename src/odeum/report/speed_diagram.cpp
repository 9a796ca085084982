// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/speed_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"
#include "odeum/report/panels.hpp"
#include "odeum/report/plots.hpp"

namespace odeum::report {
namespace {

using study::PrecisionRow;

constexpr double width = 640, height = 400;
constexpr double left = 62, right = 14, top = 10, bottom = 44;

/// From values to coordinates of the picture.
struct Axes {
  LogRange time, error;

  double x(double ns) const {
    return left + (width - left - right) * std::log(ns / time.low) / std::log(time.high / time.low);
  }
  double y(double value) const {
    return top + (height - top - bottom) * std::log(error.high / value) /
                     std::log(error.high / error.low);
  }
};

bool drawable(const PrecisionRow& row, double worst) {
  return row.repetitions > 0 && row.wall_ns_min > 0 && row.error > 0 && row.error <= worst;
}

std::string svg_text(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", x, y, anchor,
                     text);
}

// Ticks at powers of ten; where these are few, at 2 and 5 of each as well.
std::string time_ticks(const Axes& axes) {
  std::string lines, labels;
  const bool few = axes.time.high / axes.time.low < 100;
  const int first = static_cast<int>(std::floor(std::log10(axes.time.low)));
  for (int k = first; std::pow(10.0, k) <= axes.time.high; ++k)
    for (const double m : {1.0, 2.0, 5.0}) {
      const double ns = m * std::pow(10.0, k);
      if (ns < axes.time.low || ns > axes.time.high || (m > 1 && !few)) continue;
      lines += fmt::format("M{:.1f} {}V{}", axes.x(ns), top, height - bottom);
      labels += svg_text(axes.x(ns), height - bottom + 15, "middle", show_time(ns));
    }
  return "<path class=\"grid\" d=\"" + lines + "\"/>" + labels;
}

std::string error_ticks(const Axes& axes) {
  std::string lines, labels;
  const double decades = std::log10(axes.error.high / axes.error.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 9)));
  const int first = static_cast<int>(std::ceil(std::log10(axes.error.low)));
  for (int k = first; std::pow(10.0, k) <= axes.error.high; ++k) {
    if (k % every != 0) continue;
    const double y = axes.y(std::pow(10.0, k));
    lines += fmt::format("M{} {:.1f}H{}", left, y, width - right);
    labels += svg_text(left - 6, y + 4, "end",
                       fmt::format("10<tspan dy=\"-5\" font-size=\"9\">{}</tspan>", k));
  }
  return "<path class=\"grid\" d=\"" + lines + "\"/>" + labels;
}

std::string title_of(const PrecisionRow& row) {
  return escape(fmt::format("{}/{}, {} {:.3g}: {}, error {:.2g}", row.library, row.solver,
                            row.mode == Mode::adaptive ? "tolerance" : "step", row.setting,
                            show_time(row.wall_ns_min), row.error));
}

std::string points(const std::vector<PrecisionRow>& rows, const std::string& library,
                   std::size_t style, const Axes& axes, double worst) {
  std::string html;
  for (const PrecisionRow& row : rows)
    if (row.library == library && drawable(row, worst))
      html += fmt::format("<use href=\"#m{}\" x=\"{:.1f}\" y=\"{:.1f}\"{}><title>{}</title></use>",
                          style, axes.x(row.wall_ns_min), axes.y(row.error),
                          row.pareto ? " class=\"best\"" : "", title_of(row));
  return html.empty() ? html : "<g class=\"cloud\">" + html + "</g>";
}

// A staircase: with any time between two points the error of the faster one is what one gets.
std::string front(std::vector<PrecisionRow> rows, const Axes& axes, double worst,
                  const char* style) {
  std::erase_if(rows, [&](const PrecisionRow& row) { return !drawable(row, worst); });
  study::mark_pareto(rows);
  std::erase_if(rows, [](const PrecisionRow& row) { return !row.pareto; });
  if (rows.empty()) return {};
  std::sort(rows.begin(), rows.end(),
            [](const auto& a, const auto& b) { return a.wall_ns_min < b.wall_ns_min; });
  std::string path = fmt::format("M{:.1f} {}", axes.x(rows.front().wall_ns_min), top);
  for (const PrecisionRow& row : rows)
    path += fmt::format("H{:.1f}V{:.1f}", axes.x(row.wall_ns_min), axes.y(row.error));
  return fmt::format("<path class=\"{}\" d=\"{}H{}\"/>", style, path, width - right);
}

// The sixth colour is left out: it is too near the first, which is our own.
std::size_t style_of_library(std::size_t index) {
  return index < 5 ? index : std::min(index + 1, curves_per_panel - 1);
}

}  // namespace

std::string show_time(double ns) {
  if (std::isnan(ns)) return "–";
  if (ns < 999.5) return fmt::format("{:.3g} ns", ns);
  if (ns < 999.5e3) return fmt::format("{:.3g} µs", ns / 1e3);
  if (ns < 999.5e6) return fmt::format("{:.3g} ms", ns / 1e6);
  return fmt::format("{:.3g} s", ns / 1e9);
}

std::string speed_diagram(const std::vector<PrecisionRow>& rows,
                          const std::vector<std::string>& libraries, double floor, double worst) {
  Axes axes;
  std::vector<PrecisionRow> peers;
  for (const PrecisionRow& row : rows) {
    if (!drawable(row, worst)) continue;
    axes.time.include(row.wall_ns_min);
    axes.error.include(row.error);
    if (row.library != "odeum") peers.push_back(row);
  }
  if (axes.time.empty() || axes.error.empty()) return {};
  axes.time = axes.time.widened(1.4);
  axes.error = axes.error.widened(3);
  std::string html = fmt::format(
      "<svg class=\"plot speed\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"error against "
      "time "
      "per solve\">",
      width, height);
  html += time_ticks(axes) + error_ticks(axes);
  html += fmt::format("<path d=\"M{0} {1}V{2}H{3}\"/>", left, top, height - bottom, width - right);
  if (floor > axes.error.low && floor < axes.error.high)
    html += fmt::format("<path class=\"guide\" stroke-dasharray=\"2 3\" d=\"M{} {:.1f}H{}\"/>",
                        left, axes.y(floor), width - right) +
            svg_text(left + 6, axes.y(floor) - 4, "start", "truth's floor");
  // Own points last, so that they lie on top.
  for (std::size_t i = libraries.size(); i-- > 0;)
    html += points(rows, libraries[i], style_of_library(i), axes, worst);
  html += front(std::move(peers), axes, worst, "front peers") + front(rows, axes, worst, "front");
  html +=
      svg_text((left + width - right) / 2, height - 8, "middle", "time per solve (least), log") +
      fmt::format(
          "<text transform=\"translate(14,{}) rotate(-90)\" text-anchor=\"middle\">"
          "largest error, absolute, log</text>",
          (top + height - bottom) / 2);
  return html + "</svg>";
}

std::string speed_legend(const std::vector<std::string>& libraries) {
  std::string html = "<ul class=\"legend\">";
  for (std::size_t i = 0; i < libraries.size(); ++i)
    html += fmt::format(
        "<li><svg viewBox=\"-9 -5 18 10\" aria-hidden=\"true\"><use href=\"#m{}\"/></svg>{}</li>",
        style_of_library(i), escape(libraries[i]));
  for (const auto& [style, text] : {std::pair{"front",
                                              "Pareto front: nobody is both faster and "
                                              "more exact"},
                                    {"front peers", "the same of the peers alone"}})
    html += fmt::format(
        "<li><svg viewBox=\"-9 -5 18 10\" aria-hidden=\"true\"><path class=\"{}\" d=\"M-9 0H9\"/>"
        "</svg>{}</li>",
        style, text);
  return html + "</ul>";
}

}  // namespace odeum::report
