// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/log_diagram.hpp"
#include "odeum/studies/hard_cases/section.hpp"

namespace odeum::report {
namespace {

using study::DriftRow;

// Below it nothing but rounding is seen, above it nothing of the solution is left.
constexpr double lowest = 1e-17, highest = 1e2;

/// The kinds of line, those drawn first lying below.
enum Kind : std::size_t { peer, own, symplectic };
struct Style {
  const char *name, *meaning;
};
constexpr std::array<Style, 3> styles{
    {{"run peer", "other peers"}, {"run own", "other own methods"}, {"run kept", "symplectic"}}};

std::string path(const std::vector<const DriftRow*>& series, const LogAxes& axes) {
  std::string d;
  for (const DriftRow* row : series) {
    if (!(row->relative_error > lowest) || !(row->time > 0)) continue;
    d += fmt::format("{}{:.0f} {:.0f}", d.empty() ? "M" : "L", axes.x(row->time),
                     axes.y(std::min(row->relative_error, highest)));
    if (row->relative_error >= highest) break;  // and what follows is as far off
  }
  return d;
}

}  // namespace

std::string drift_diagram(const PageContext& page, const std::string& case_id,
                          const std::string& quantity) {
  const RowsByPair<DriftRow> pairs = by_pair(page.data.hard_cases.drift.rows);
  std::array<std::string, styles.size()> lines;
  LogAxes axes;
  std::map<std::string, std::vector<const DriftRow*>> series_of;
  for (const auto& [pair, rows] : pairs) {
    if (pair.first != case_id) continue;
    for (const DriftRow* row : rows) {
      if (row->invariant != quantity || std::isnan(row->relative_error)) continue;
      series_of[pair.second].push_back(row);
      axes.across.include(row->time);
      if (row->relative_error > lowest) axes.up.include(std::min(row->relative_error, highest));
    }
  }
  if (axes.across.empty() || axes.up.empty()) return {};
  axes.across = axes.across.widened(1.2);
  axes.up = axes.up.widened(2);
  for (const SolverInfo& solver : page.data.solvers) {
    const auto found = series_of.find(solver.id());
    if (found == series_of.end()) continue;
    const Kind kind = is_symplectic(page.data, solver) ? symplectic
                      : solver.library == "odeum"      ? own
                                                       : peer;
    const std::string d = path(found->second, axes);
    if (!d.empty())
      lines[kind] += fmt::format("<path class=\"{}\" d=\"{}\"><title>{}</title></path>",
                                 styles[kind].name, d, escape(solver.id()));
  }
  std::string legend = "<ul class=\"legend\">";
  std::string html = open_diagram(axes, "relative error of the energy against time",
                                  [](double value) { return show_number(value); });
  for (std::size_t kind = 0; kind < styles.size(); ++kind) {
    html += lines[kind];
    if (!lines[kind].empty())
      legend += fmt::format(
          "<li><svg viewBox=\"-9 -5 18 10\" aria-hidden=\"true\"><path class=\"{}\" d=\"M-9 0H9\"/>"
          "</svg>{}</li>",
          styles[kind].name, styles[kind].meaning);
  }
  html += close_diagram("time, log", "relative error, log");
  return fmt::format("<figure><figcaption><code>{}</code>: {}</figcaption>{}{}</ul></figure>\n",
                     escape(case_id), escape(quantity), html, legend);
}

}  // namespace odeum::report
