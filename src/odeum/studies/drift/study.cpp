// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "odeum/record/table.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/solver_tables.hpp"
#include "odeum/studies/drift/section.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::show_number;
using Series = std::vector<const DriftRow*>;

/// Errors up to it are the rounding of ten thousand steps.
constexpr double rounding = 1e-11;

/// The cases on which peers are run in a report too: an orbit and an oscillator.
constexpr const char* drawn_cases[] = {"kepler_e06", "osc_undamped"};

/// By case, what stands in its column: the energy where that is an invariant, else the first one.
std::map<std::string, std::string> quantities_of(const std::vector<DriftRow>& rows) {
  std::map<std::string, std::string> quantity_of;
  for (const DriftRow& row : rows)
    if (row.status != "not_applicable")
      if (const auto [place, is_new] = quantity_of.try_emplace(row.case_id, row.invariant);
          !is_new && row.invariant == "energy")
        place->second = row.invariant;
  return quantity_of;
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

constexpr const char* introduction =
    "<p>The error of a quantity that the exact solution conserves, after ten thousand steps (a "
    "thousand of large systems), each half of the largest step of the study of orders. A cell is "
    "the power of ten of the largest relative error on the way: blue is near rounding, orange "
    "large. A sign gives the growth over the last two decades of time: none, it is bounded; ~ like "
    "the square root of time, as random rounding does; ↗ in proportion to time; ⇑ faster. ✗: the "
    "run ended early. In free fall kinetic and potential energy grow without bound, and their "
    "rounding with them. The tooltip of a cell gives the numbers.</p>\n";

std::string drift_html(const report::Facts& facts, const std::vector<DriftRow>& rows) {
  const std::map<std::string, std::string> quantity_of = quantities_of(rows);
  std::vector<Cell> head;
  std::vector<const report::CaseFacts*> cases;
  for (const report::CaseFacts& c : facts.cases)
    if (const auto found = quantity_of.find(c.id); found != quantity_of.end()) {
      cases.push_back(&c);
      head.push_back(report::case_head(c, found->second == "energy" ? "" : ": " + found->second));
    }
  const auto shown = report::by_solver(rows, [&](const DriftRow& row) {
    const auto found = quantity_of.find(row.case_id);
    return found != quantity_of.end() && row.invariant == found->second;
  });
  const auto cells = [&](const Series& of_solver) {
    std::map<std::string, Series> of_case;
    for (const DriftRow* row : of_solver) of_case[row->case_id].push_back(row);
    std::vector<Cell> row;
    bool any = false;
    for (const report::CaseFacts* c : cases) {
      const Series& series = of_case[c->id];
      row.push_back(cell_of(series));
      any |= !series.empty();
    }
    return any ? row : std::vector<Cell>();
  };
  std::string diagrams;
  for (const char* id : drawn_cases) diagrams += drift_diagram(facts, rows, id);
  if (!diagrams.empty()) diagrams = "<div class=\"speeds\">\n" + diagrams + "</div>\n";
  return introduction + diagrams +
         report::solver_tables(facts, "matrix drifts", head, shown, cells);
}

/// A series of drift.csv in one line.
struct DriftSummary {
  DriftRow last;
  double worst = record::nan, latest = record::nan;

  static void each(auto& row, auto&& visit) {
    DriftRow::each(row.last, visit);
    visit("worst", row.worst), visit("latest", row.latest);
  }
  bool continues_with(const DriftRow& row) const {
    return row.case_id == last.case_id && row.library == last.library &&
           row.solver == last.solver && row.invariant == last.invariant;
  }
};

std::vector<DriftSummary> summarise(const std::vector<DriftRow>& rows) {
  std::vector<DriftSummary> lines;
  for (const DriftRow& row : rows) {
    if (lines.empty() || !lines.back().continues_with(row)) lines.emplace_back();
    DriftSummary& line = lines.back();
    line.last = row;
    line.worst = std::fmax(line.worst, row.relative_error);
    if (!std::isnan(row.relative_error)) line.latest = row.relative_error;
  }
  return lines;
}

std::string table(const DriftResult& result) {
  std::string text = record::table_of(summarise(result.rows), {{"case", "{case}"},
                                                               {"solver", "{library}/{solver}"},
                                                               {"invariant", "{invariant}"},
                                                               {"to time", "{time:.4g}"},
                                                               {"worst", "{worst:.2e}"},
                                                               {"last", "{latest:.2e}"},
                                                               {"status", "{status}: {detail}"}})
                         .text();
  if (!result.horizons.empty())
    text += '\n' + record::table_of(result.horizons, {{"case", "{case}"},
                                                      {"solver", "{library}/{solver}"},
                                                      {"mode", "{mode}"},
                                                      {"setting", "{setting:.2g}"},
                                                      {"1e-3 at", "{horizon:.2f}"},
                                                      {"status", "{status}: {detail}"}})
                       .text();
  return text;
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
  if (before == 0) return now == 0 ? 0 : record::nan;
  return std::log10(now / before);
}

void add_section(report::Page& page, const DriftResult& result, const Origin& origin) {
  std::string html = origin_text(origin, record::is_empty(result));
  if (!result.rows.empty()) html += drift_html(page.facts(), result.rows);
  html += oscillator_part(page.facts(), result.rows) + horizons_part(page.facts(), result.horizons);
  page.section({.id = "drift",
                .title = "Drift of energy and invariants",
                .place = origin.place,
                .html = html,
                .short_title = "Drift"});
}

// A report runs own solvers on every case; peers on an orbit, an oscillator and, for its horizon, a
// chaotic case, without arkode, whose many tables would take as long as all the rest.
std::unique_ptr<Study> make_drift() {
  return make_study<DriftResult>(
      {.name = "drift",
       .help = "the errors of energy and invariants after a long time",
       .place = 60,
       .report = {{.solvers = {"odeum/*"}},
                  {.cases = {"kepler_e06", "osc_undamped"}, .solvers = {"!odeum/*"}},
                  {.cases = {"lorenz_kehlet_logg"}, .solvers = {"!odeum/*", "!arkode/*"}}}},
      {.measure = measure_drift, .table = table, .section = add_section});
}

}  // namespace odeum::study
