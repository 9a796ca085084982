// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/speed_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"
#include "odeum/report/log_diagram.hpp"
#include "odeum/report/panels.hpp"

namespace odeum::report {
namespace {

using study::PrecisionRow;

constexpr double left = LogAxes::left, right = LogAxes::right, top = LogAxes::top,
                 bottom = LogAxes::bottom, width = LogAxes::width, height = LogAxes::height;

bool drawable(const PrecisionRow& row, double worst) {
  return row.repetitions > 0 && row.wall_ns_min > 0 && row.error > 0 && row.error <= worst;
}

std::string title_of(const PrecisionRow& row) {
  return escape(fmt::format("{}/{}, {} {:.3g}: {}, error {:.2g}", row.library, row.solver,
                            row.mode == Mode::adaptive ? "tolerance" : "step", row.setting,
                            show_time(row.wall_ns_min), row.error));
}

std::string points(const std::vector<PrecisionRow>& rows, const std::string& library,
                   std::size_t style, const LogAxes& axes, double worst) {
  std::string html;
  for (const PrecisionRow& row : rows)
    if (row.library == library && drawable(row, worst))
      html += fmt::format("<use href=\"#m{}\" x=\"{:.1f}\" y=\"{:.1f}\"{}><title>{}</title></use>",
                          style, axes.x(row.wall_ns_min), axes.y(row.error),
                          row.pareto ? " class=\"best\"" : "", title_of(row));
  return html.empty() ? html : "<g class=\"cloud\">" + html + "</g>";
}

// A staircase: with any time between two points the error of the faster one is what one gets.
std::string front(std::vector<PrecisionRow> rows, const LogAxes& axes, double worst,
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
  LogAxes axes;
  std::vector<PrecisionRow> peers;
  for (const PrecisionRow& row : rows) {
    if (!drawable(row, worst)) continue;
    axes.across.include(row.wall_ns_min);
    axes.up.include(row.error);
    if (row.library != "odeum") peers.push_back(row);
  }
  if (axes.across.empty() || axes.up.empty()) return {};
  axes.across = axes.across.widened(1.4);
  axes.up = axes.up.widened(3);
  std::string html = open_diagram(axes, "error against time per solve", show_time);
  if (floor > axes.up.low && floor < axes.up.high)
    html += fmt::format("<path class=\"guide\" stroke-dasharray=\"2 3\" d=\"M{} {:.1f}H{}\"/>",
                        left, axes.y(floor), width - right) +
            svg_text(left + 6, axes.y(floor) - 4, "start", "truth's floor");
  // Own points last, so that they lie on top.
  for (std::size_t i = libraries.size(); i-- > 0;)
    html += points(rows, libraries[i], style_of_library(i), axes, worst);
  html += front(std::move(peers), axes, worst, "front peers") + front(rows, axes, worst, "front");
  html += close_diagram("time per solve (least), log", "largest error, absolute, log");
  return html;
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
