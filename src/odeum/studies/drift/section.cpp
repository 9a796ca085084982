// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/drift/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "odeum/report/html.hpp"
#include "odeum/report/solver_tables.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::show_number;
using Series = std::vector<const DriftRow*>;

/// Errors up to it are the rounding of ten thousand steps.
constexpr double rounding = 1e-11;

/// The cases on which peers are run in a report too: an orbit and an oscillator.
constexpr const char* drawn_cases[] = {"kepler_e06", "osc_undamped"};

/// A column of the table: a case, and its energy where that is an invariant, else the first one.
struct Column {
  const report::CaseFacts* c;
  std::string quantity;
};

std::vector<Column> columns_of(const report::Facts& facts, const std::vector<DriftRow>& rows) {
  std::map<std::string, std::string> quantity_of;
  for (const DriftRow& row : rows)
    if (row.status != "not_applicable")
      if (const auto [place, is_new] = quantity_of.try_emplace(row.case_id, row.invariant);
          !is_new && row.invariant == "energy")
        place->second = row.invariant;
  std::vector<Column> columns;
  for (const report::CaseFacts& c : facts.cases)
    if (const auto found = quantity_of.find(c.id); found != quantity_of.end())
      columns.push_back({&c, found->second});
  return columns;
}

// Blue: rounding; white; orange: the quantity is gone.
std::string colour_of(double worst) {
  if (worst <= 1e-12) return "t-3";
  if (worst <= 1e-9) return "t-2";
  if (worst <= 1e-6) return "t-1";
  if (worst <= 1e-4) return "";
  return worst <= 1e-2 ? "t1" : worst <= 1 ? "t2" : "t3";
}

const char* sign_of(double worst, double power) {
  if (worst <= rounding || !(power > 0.25)) return "";
  return power <= 0.75 ? "~" : power <= 1.5 ? "↗" : "⇑";
}

Cell cell_of(const Series& series) {
  if (series.empty()) return {.text = "·", .style = "not_applicable"};
  const DriftRow& last = *series.back();
  double worst = 0;
  for (const DriftRow* row : series) worst = std::fmax(worst, row->relative_error);
  const double power = growth_power(series);
  std::string title =
      fmt::format("step {}, to t = {}: at most {}, at the end {}", show_number(last.step),
                  show_number(last.time), show_number(worst, 2), show_number(last.relative_error));
  if (worst > rounding && !std::isnan(power)) title += fmt::format("; grows as t^{:.1f}", power);
  if (last.status != to_string(Status::ok))
    return {.text = "✗",
            .style = "failed",
            .title = title + fmt::format("; {} {}", last.status, last.detail)};
  const std::string exponent =
      worst == 0 ? "0" : fmt::format("{:.0f}", std::floor(std::log10(worst) + 0.5));
  return {.text = exponent + sign_of(worst, power), .style = colour_of(worst), .title = title};
}

constexpr const char* text =
    "<p>The error of a quantity that the exact solution conserves, after ten thousand steps (a "
    "thousand of large systems), each half of the largest step of the study of orders. A cell is "
    "the power of ten of the largest relative error on the way: blue is near rounding, orange "
    "large. A sign gives the growth over the last two decades of time: none, it is bounded; ~ like "
    "the square root of time, as random rounding does; ↗ in proportion to time; ⇑ faster. ✗: the "
    "run ended early. In free fall kinetic and potential energy grow without bound, and their "
    "rounding with them. The tooltip of a cell gives the numbers.</p>\n";

std::string drift_html(const report::Facts& facts, const std::vector<DriftRow>& rows) {
  const std::vector<Column> columns = columns_of(facts, rows);
  std::map<std::pair<std::string, std::string>, Series> series_of;
  for (const DriftRow& row : rows)
    for (const Column& column : columns)
      if (row.case_id == column.c->id && row.invariant == column.quantity)
        series_of[{row.case_id, row.library + "/" + row.solver}].push_back(&row);
  std::vector<Cell> head;
  for (const Column& column : columns)
    head.push_back(
        report::case_head(*column.c, column.quantity == "energy" ? "" : ": " + column.quantity));
  const auto cells = [&](const SolverInfo& solver) {
    std::vector<Cell> row;
    bool any = false;
    for (const Column& column : columns) {
      const Series& series = series_of[{column.c->id, solver.id()}];
      row.push_back(cell_of(series));
      any |= !series.empty();
    }
    return any ? row : std::vector<Cell>();
  };
  std::string diagrams;
  for (const char* id : drawn_cases) diagrams += drift_diagram(facts, rows, id);
  if (!diagrams.empty()) diagrams = "<div class=\"speeds\">\n" + diagrams + "</div>\n";
  return text + diagrams + report::solver_tables(facts, "matrix drifts", head, cells);
}

}  // namespace

double growth_power(const std::vector<const DriftRow*>& series) {
  double end = 0, before = 0, now = 0;
  for (const DriftRow* row : series) end = std::fmax(end, row->time);
  for (const DriftRow* row : series) {
    if (std::isnan(row->relative_error)) continue;
    if (row->time > end / 10)
      now = std::fmax(now, row->relative_error);
    else if (row->time > end / 100)
      before = std::fmax(before, row->relative_error);
  }
  if (before == 0) return now == 0 ? 0 : DriftRow::nan;
  return std::log10(now / before);
}

void add_section(report::Page& page, const DriftResult& result, const report::Origin& origin) {
  const bool empty = result.rows.empty() && result.horizons.empty();
  std::string html = report::origin_text(origin, empty);
  if (!result.rows.empty()) html += drift_html(page.facts(), result.rows);
  html += oscillator_part(page.facts(), result.rows) + horizons_part(page.facts(), result.horizons);
  page.section({.id = "drift",
                .title = "Drift of energy and invariants",
                .place = origin.place,
                .html = html,
                .short_title = "Drift"});
}

}  // namespace odeum::study
