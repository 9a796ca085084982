// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/report/summary.hpp"

namespace odeum::report {
namespace {

using study::ConvergenceRow;

/// What all plots of a case share, so that they can be compared by eye.
struct CaseAxes {
  LogRange step, evaluations, error;
};

// Beyond a hundred times the initial state an error tells nothing but that the run went astray.
bool worth_drawing(const CaseFacts& c, double error) {
  return std::isfinite(error) && error > 0 && error <= 100 * c.scale;
}

CaseAxes axes_of(const ReportData& data, const CaseFacts& c) {
  CaseAxes axes;
  for (const ConvergenceRow& row : data.convergence.rows) {
    if (row.case_id != c.id || !worth_drawing(c, row.error_rms)) continue;
    axes.error.include(row.error_rms);
    if (row.mode == Mode::fixed) axes.step.include(row.step);
    axes.evaluations.include(static_cast<double>(row.counters.rhs_evaluations));
  }
  return axes;
}

using Abscissa = double (*)(const ConvergenceRow&);

Curve curve_of(const PageContext& page, const CaseFacts& c, const Panel& panel, std::size_t style,
               Mode mode, Abscissa abscissa) {
  Curve curve{.style = style, .dashed = mode == Mode::adaptive, .points = {}};
  for (const ConvergenceRow* row : page.lookup.rows(c.id, *panel.solvers[style], mode))
    if (const double x = abscissa(*row); x > 0 && worth_drawing(c, row->error_rms))
      curve.points.emplace_back(x, row->error_rms);
  return curve;
}

std::vector<int> orders_in(const Panel& panel) {
  std::set<int> orders;
  for (const SolverInfo* solver : panel.solvers)
    if (!std::isnan(solver->order)) orders.insert(static_cast<int>(std::lround(solver->order)));
  return {orders.begin(), orders.end()};
}

std::string panel_figure(PageContext& page, const CaseFacts& c, const CaseAxes& axes,
                         const Panel& panel) {
  // Time is in seconds where there is mechanics; elsewhere in whatever the equation has.
  const bool seconds = c.has_tag("mechanical");
  LogPlot by_step{.x = axes.step.widened(1.2),
                  .y = axes.error.widened(3),
                  .x_label = seconds ? "step h [s]" : "step h [unit of t]",
                  .y_label = "error (root mean square)",
                  .curves = {},
                  .slopes = orders_in(panel),
                  .floor = c.truth_floor};
  LogPlot by_cost{.x = axes.evaluations.widened(1.5),
                  .y = by_step.y,
                  .x_label = "evaluations of f",
                  .y_label = "error (root mean square)",
                  .curves = {},
                  .slopes = {},
                  .floor = c.truth_floor};
  std::vector<bool> shown(panel.solvers.size());
  for (std::size_t i = 0; i < panel.solvers.size(); ++i) {
    const auto add = [&](LogPlot& plot, Mode mode, Abscissa abscissa) {
      Curve curve = curve_of(page, c, panel, i, mode, abscissa);
      if (curve.points.empty()) return;
      plot.curves.push_back(std::move(curve));
      shown[i] = true;
    };
    constexpr Abscissa step = [](const ConvergenceRow& row) { return row.step; };
    constexpr Abscissa evaluations = [](const ConvergenceRow& row) {
      return static_cast<double>(row.counters.rhs_evaluations);
    };
    add(by_step, Mode::fixed, step);
    add(by_cost, Mode::fixed, evaluations);
    add(by_cost, Mode::adaptive, evaluations);
  }
  if (by_step.curves.empty() && by_cost.curves.empty()) return {};
  std::string plots;
  for (const LogPlot* plot : {&by_step, &by_cost})
    if (!plot->curves.empty())
      plots += page.pictures.add(draw(*plot), fmt::format("{} against {}, {}", plot->y_label,
                                                          plot->x_label, panel.library));
  return fmt::format(
      "<figure class=\"panel\"><figcaption><strong>{}</strong> {}</figcaption>"
      "<div class=\"plots\">{}</div>{}</figure>\n",
      escape(panel.library), escape(panel.contents), plots, legend(panel, shown));
}

std::string order_row(const study::OrderRow& row) {
  const judge::OrderFit& fit = row.fit;
  const auto fixed = [](double value) {
    return std::isnan(value) ? std::string("–") : fmt::format("{:.2f}", value);
  };
  return fmt::format(
      "<tr><th>{}/{}</th><td>{}</td><td>{}</td><td>{}</td><td>{} … {}</td><td>{} … "
      "{}</td><td>{}</td>"
      "<td>{}</td><td>{}</td><td class=\"reason\">{}</td></tr>\n",
      escape(row.library), escape(row.solver), to_string(row.mode), show_number(row.claimed_order),
      fixed(fit.order), fixed(fit.low), fixed(fit.high), show_number(fit.step_coarsest),
      show_number(fit.step_finest), fit.points, show_number(fit.floor), verdict_chip(fit.verdict),
      escape(fit.reason));
}

std::string orders_table(const std::string& rows) {
  if (rows.empty()) return {};
  return "<section id=\"orders\"><h2>Orders</h2>\n<div class=\"wide\"><table class=\"numbers "
         "orders\"><thead>"
         "<tr><th>solver</th><th>mode</th><th>claimed</th><th>measured</th><th>95 % interval</th>"
         "<th>window, "
         "h</th><th>points</th><th>floor</th><th>verdict</th><th>reason</th></tr></thead>"
         "<tbody>\n" +
         rows + "</tbody></table></div></section>\n";
}

// From case to case and back to the whole, in the order of the overview.
std::string navigation(const PageContext& page, std::size_t index) {
  const auto link = [&](std::size_t i, const char* arrow) {
    return fmt::format("<a href=\"../{}\">{}{}</a>", page.case_address(i), arrow,
                       escape(page.data.cases[i].id));
  };
  std::string html = "<nav><a href=\"../index.html\">Odeum report</a>";
  if (index > 0) html += link(index - 1, "← ");
  if (index + 1 < page.data.cases.size()) html += link(index + 1, "→ ");
  return html + "</nav>\n";
}

// Links to the parts that the page has.
std::string contents(const std::string& html) {
  std::string links;
  for (const auto& [id, title] : {std::pair{"plots", "Error against step and cost"},
                                  {"time", "In the course of time"},
                                  {"precision", "Speed against error"},
                                  {"orders", "Orders"}})
    if (html.find(fmt::format("<section id=\"{}\"", id)) != std::string::npos)
      links += fmt::format("<a href=\"#{}\">{}</a>", id, title);
  return "<nav>" + links + "</nav>\n";
}

}  // namespace

std::string case_body(PageContext& page, std::size_t index) {
  const CaseFacts& c = page.data.cases[index];
  VerdictCounts counts{};
  std::string orders;
  for (const study::OrderRow& row : page.data.convergence.orders) {
    if (row.case_id != c.id) continue;
    ++counts[static_cast<std::size_t>(row.fit.verdict)];
    if (row.fit.verdict != judge::Verdict::not_applicable || !std::isnan(row.fit.order))
      orders += order_row(row);
  }
  std::string figures;
  const CaseAxes axes = axes_of(page.data, c);
  if (!axes.error.empty())
    for (const Panel& panel : page.panels) figures += panel_figure(page, c, axes, panel);
  if (figures.empty()) figures = "<p>Nothing to draw: no run of this case gave an error.</p>\n";
  const std::string floor =
      c.truth_floor > 0 ? fmt::format(" (known to {})", show_number(c.truth_floor)) : "";
  const std::string parts =
      "<section id=\"plots\"><h2>Error against step and cost</h2>\n<p>Errors are absolute, "
      "root mean squares over components and stops; those beyond a hundred times the initial state "
      "are "
      "not drawn. Axes are the same throughout a case. Thin lines show the slopes of the orders "
      "claimed; dashed curves are runs to a tolerance, plain ones runs at a fixed step.</p>\n"
      "<div class=\"panels\">\n" +
      figures + "</div></section>\n" + cloth_part(page, c) + precision_part(page, c) +
      orders_table(orders);
  return navigation(page, index) +
         fmt::format(
             "<h1>{}</h1>\n<p class=\"lead\"><code>{}</code></p>\n"
             "<dl "
             "class=\"facts\"><dt>Equation</dt><dd><code>{}</code></dd><dt>Source</dt><dd>{}</dd>"
             "<dt>Truth</dt><dd>{}{}</dd><dt>Orders</dt><dd>{} {}</dd></dl>\n",
             escape(c.title), escape(c.id), escape(c.equation), escape(c.source), escape(c.truth),
             floor, verdict_bar(counts), verdict_words(counts)) +
         contents(parts) + parts;
}

}  // namespace odeum::report
