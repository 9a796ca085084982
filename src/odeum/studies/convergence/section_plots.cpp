// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "odeum/report/chart.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/panels.hpp"
#include "odeum/studies/convergence/section.hpp"

namespace odeum::study {
namespace {

using report::Axis;
using report::CaseFacts;
using report::Chart;
using report::Panel;

/// The rows of a result by pair.
struct Lookup {
  std::map<PairKey, std::vector<const ConvergenceRow*>> rows;
  std::map<PairKey, std::vector<const TimeRow*>> times;
};

template <class Row>
std::vector<const Row*> rows_of(const std::map<PairKey, std::vector<const Row*>>& rows,
                                const CaseFacts& c, const SolverInfo& solver, Mode mode) {
  const auto found = rows.find({c.id, solver.id(), mode});
  return found == rows.end() ? std::vector<const Row*>() : found->second;
}

// An error beyond a hundred times the initial state only says that the run diverged.
bool is_drawn(double error, double scale) {
  return std::isfinite(error) && error > 0 && error <= 100 * scale;
}

/// A panel: charts with what belongs over each, and the solvers that any of them shows.
struct Figure {
  std::string charts;
  std::set<std::size_t> shown;

  void add(const Chart& chart, const std::string& caption = {}) {
    if (chart.empty()) return;
    charts += caption.empty()
                  ? chart.svg()
                  : "<div><span class=\"when\">" + caption + "</span>" + chart.svg() + "</div>";
  }
  std::string html(const Panel& panel, const char* style) const {
    if (charts.empty()) return {};
    std::vector<report::Key> keys;
    for (const std::size_t i : shown)
      keys.push_back({.text = panel.solvers[i]->method, .style = i, .line = "sample"});
    return fmt::format(
        "<figure class=\"{}\"><figcaption><strong>{}</strong> {}</figcaption>"
        "<div class=\"plots\">{}</div>{}</figure>\n",
        style, report::escape(panel.library), report::escape(panel.contents), charts,
        report::legend(keys));
  }
};

using Abscissa = double (*)(const ConvergenceRow&);
double step_of(const ConvergenceRow& row) { return row.step; }
double evaluations_of(const ConvergenceRow& row) {
  return static_cast<double>(row.counters.rhs_evaluations);
}

/// What all plots of a case share, so that they can be compared by eye.
struct CaseAxes {
  Axis step, evaluations, error;
};

CaseAxes axes_of(const std::vector<const ConvergenceRow*>& rows, const CaseFacts& c) {
  CaseAxes axes;
  for (const ConvergenceRow* row : rows) {
    if (!is_drawn(row->error_rms, c.scale)) continue;
    axes.error.include(row->error_rms);
    axes.evaluations.include(evaluations_of(*row));
    if (row->mode == Mode::fixed) axes.step.include(row->step);
  }
  return {axes.step.widened(1.2), axes.evaluations.widened(1.5), axes.error.widened(3)};
}

std::vector<int> orders_in(const Panel& panel) {
  std::set<int> orders;
  for (const SolverInfo* solver : panel.solvers)
    if (!std::isnan(solver->order)) orders.insert(static_cast<int>(std::lround(solver->order)));
  return {orders.begin(), orders.end()};
}

Chart error_chart(const CaseFacts& c, const Panel& panel, const Axis& x, const Axis& y,
                  const std::string& x_words) {
  Chart chart(report::small_chart, x, y,
              {.x = x_words,
               .y = "error (root mean square)",
               .description = "error against " + x_words + ", " + panel.library});
  chart.level(c.truth_floor, "truth");
  return chart;
}

std::string error_panel(const Lookup& lookup, const CaseFacts& c, const CaseAxes& axes,
                        const Panel& panel) {
  // Time is in seconds in mechanics; elsewhere in whatever unit the equation has.
  Chart by_step = error_chart(c, panel, axes.step, axes.error,
                              c.has_tag("mechanical") ? "step h [s]" : "step h [unit of t]");
  Chart by_cost = error_chart(c, panel, axes.evaluations, axes.error, "evaluations of f");
  if (!axes.step.empty()) by_step.slopes(orders_in(panel));
  Figure figure;
  const auto add = [&](Chart& chart, std::size_t i, Mode mode, Abscissa abscissa) {
    std::vector<report::ChartPoint> points;
    for (const ConvergenceRow* row : rows_of(lookup.rows, c, *panel.solvers[i], mode))
      if (const double x = abscissa(*row); x > 0 && is_drawn(row->error_rms, c.scale))
        points.emplace_back(x, row->error_rms);
    chart.curve(points, i, mode == Mode::adaptive);
    if (!points.empty()) figure.shown.insert(i);
  };
  for (std::size_t i = 0; i < panel.solvers.size(); ++i) {
    add(by_step, i, Mode::fixed, step_of);
    add(by_cost, i, Mode::fixed, evaluations_of);
    add(by_cost, i, Mode::adaptive, evaluations_of);
  }
  figure.add(by_step);
  figure.add(by_cost);
  return figure.html(panel, "panel");
}

struct Quantity {
  const char *label, *name;
  double TimeRow::*error;
};
constexpr Quantity quantities[] = {
    {"position RMS [m]", "Position", &TimeRow::error_rms},
    {"energy error", "Energy, relative to the truth's largest", &TimeRow::energy_error}};

/// What the plots of one quantity of one cloth share.
struct TimeAxes {
  std::set<double> times;
  Axis step, error;
};

std::string time_panel(const Lookup& lookup, const CaseFacts& c, const Quantity& quantity,
                       const TimeAxes& axes, const Panel& panel) {
  Figure figure;
  for (const double time : axes.times) {
    const std::string when = fmt::format("t = {} s", report::show_number(time));
    Chart chart(report::small_chart, axes.step.widened(1.2), axes.error.widened(3),
                {.x = "step h [s]",
                 .y = quantity.label,
                 .description = fmt::format("{} against step at {}, {}", quantity.label, when,
                                            panel.library)});
    for (std::size_t i = 0; i < panel.solvers.size(); ++i) {
      std::vector<report::ChartPoint> points;
      for (const TimeRow* row : rows_of(lookup.times, c, *panel.solvers[i], Mode::fixed))
        if (row->time == time && is_drawn(row->*quantity.error, 1))
          points.emplace_back(row->step, row->*quantity.error);
      chart.curve(points, i);
      if (!points.empty()) figure.shown.insert(i);
    }
    figure.add(chart, when);
  }
  return figure.html(panel, "panel four");
}

std::string cloth_html(const Lookup& lookup, const std::vector<TimeRow>& times, const CaseFacts& c,
                       const std::vector<Panel>& panels) {
  std::string html =
      "<p>How far the particles are from where they should be (root mean square), and the error of "
      "the energy, against a fixed step, at each time of the reference.</p>\n";
  for (const Quantity& quantity : quantities) {
    TimeAxes axes;
    for (const TimeRow& row : times) {
      if (row.case_id != c.id || row.mode != Mode::fixed || !is_drawn(row.*quantity.error, 1))
        continue;
      axes.times.insert(row.time);
      axes.step.include(row.step);
      axes.error.include(row.*quantity.error);
    }
    std::string figures;
    for (const Panel& panel : panels) figures += time_panel(lookup, c, quantity, axes, panel);
    if (figures.empty()) figures = "<p>Not measured in this run.</p>\n";
    html += fmt::format("<h3>{}</h3>\n<div class=\"panels\">{}</div>\n", quantity.name, figures);
  }
  return html;
}

constexpr const char* text_of_plots =
    "<p>Errors are absolute, root mean squares over components and stops; those beyond a hundred "
    "times the initial state are not drawn. Axes are the same throughout a case. Thin lines show "
    "the slopes of the claimed orders; dashed curves are runs to a tolerance, solid ones runs at a "
    "fixed step.</p>\n";

}  // namespace

void add_plots(report::Page& page, const ConvergenceResult& result) {
  const Lookup lookup{by_pair(result.rows), by_pair(result.times)};
  const std::vector<Panel> panels = report::make_panels(page.facts().solvers);
  auto by_case = report::group_by(result.rows, &ConvergenceRow::case_id);
  for (std::size_t i = 0; i < page.facts().cases.size(); ++i) {
    const CaseFacts& c = page.facts().cases[i];
    const CaseAxes axes = axes_of(by_case[c.id], c);
    std::string figures;
    for (const Panel& panel : panels)
      if (!axes.error.empty()) figures += error_panel(lookup, c, axes, panel);
    if (figures.empty()) figures = "<p>Nothing to draw: no run of this case gave an error.</p>\n";
    page.case_part(i,
                   {.id = "plots",
                    .title = "Error against step and cost",
                    .place = 10,
                    .html = text_of_plots + ("<div class=\"panels\">\n" + figures) + "</div>\n"});
    if (c.has_tag("cloth"))
      page.case_part(i, {.id = "time",
                         .title = "The cloth over time",
                         .place = 20,
                         .html = cloth_html(lookup, result.times, c, panels)});
  }
}

}  // namespace odeum::study
