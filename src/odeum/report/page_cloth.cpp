// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"

namespace odeum::report {
namespace {

using study::TimeRow;

struct Quantity {
  const char* label;
  const char* name;
  double (*of)(const TimeRow&);
  double cap;  ///< errors beyond it are not drawn: the run went astray
};

constexpr Quantity quantities[] = {
    {"position RMS [m]", "Position", [](const TimeRow& row) { return row.error_rms; }, 100},
    {"energy error", "Energy, relative to the truth's largest",
     [](const TimeRow& row) { return row.energy_error; }, 100}};

bool worth_drawing(const Quantity& quantity, const TimeRow& row) {
  const double error = quantity.of(row);
  return row.mode == Mode::fixed && std::isfinite(error) && error > 0 && error <= quantity.cap;
}

/// What the plots of one quantity of one cloth share.
struct TimeAxes {
  std::set<double> times;
  LogRange step, error;
};

TimeAxes axes_of(const ReportData& data, const CaseFacts& c, const Quantity& quantity) {
  TimeAxes axes;
  for (const TimeRow& row : data.convergence.times) {
    if (row.case_id != c.id || !worth_drawing(quantity, row)) continue;
    axes.times.insert(row.time);
    axes.step.include(row.step);
    axes.error.include(quantity.of(row));
  }
  return axes;
}

std::string panel_figure(PageContext& page, const CaseFacts& c, const Quantity& quantity,
                         const TimeAxes& axes, const Panel& panel) {
  std::vector<bool> shown(panel.solvers.size());
  std::string plots;
  for (const double time : axes.times) {
    LogPlot plot{.x = axes.step.widened(1.2),
                 .y = axes.error.widened(3),
                 .x_label = "step h [s]",
                 .y_label = quantity.label,
                 .curves = {},
                 .slopes = {},
                 .floor = 0};
    for (std::size_t i = 0; i < panel.solvers.size(); ++i) {
      Curve curve{.style = i, .dashed = false, .points = {}};
      for (const TimeRow* row : page.lookup.times(c.id, *panel.solvers[i], Mode::fixed))
        if (row->time == time && worth_drawing(quantity, *row))
          curve.points.emplace_back(row->step, quantity.of(*row));
      if (curve.points.empty()) continue;
      plot.curves.push_back(std::move(curve));
      shown[i] = true;
    }
    if (plot.curves.empty()) continue;
    const std::string when = fmt::format("t = {} s", show_number(time));
    plots += fmt::format(
        "<div><span class=\"when\">{}</span>{}</div>", when,
        page.pictures.add(draw(plot), fmt::format("{} against step at {}, {}", quantity.label, when,
                                                  panel.library)));
  }
  if (plots.empty()) return {};
  return fmt::format(
      "<figure class=\"panel four\"><figcaption><strong>{}</strong> {}</figcaption>"
      "<div class=\"plots\">{}</div>{}</figure>\n",
      escape(panel.library), escape(panel.contents), plots, legend(panel, shown));
}

}  // namespace

std::string cloth_part(PageContext& page, const CaseFacts& c) {
  if (!c.has_tag("cloth")) return {};
  std::string html =
      "<section id=\"time\">\n<h2>The cloth in the course of time</h2>\n<p>How far the particles "
      "are from where they should be (root mean square), and how far the energy is, against a "
      "fixed step, at each time of the reference.</p>\n";
  for (const Quantity& quantity : quantities) {
    const TimeAxes axes = axes_of(page.data, c, quantity);
    std::string figures;
    if (!axes.error.empty())
      for (const Panel& panel : page.panels)
        figures += panel_figure(page, c, quantity, axes, panel);
    if (figures.empty()) figures = "<p>Not measured in this run.</p>\n";
    html += fmt::format("<h3>{}</h3>\n<div class=\"panels\">{}</div>\n", quantity.name, figures);
  }
  return html + "</section>\n";
}

}  // namespace odeum::report
