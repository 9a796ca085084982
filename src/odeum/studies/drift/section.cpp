// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/studies/hard_cases/section.hpp"

namespace odeum::report {
namespace {

using study::DriftRow;
using Series = std::vector<const DriftRow*>;

constexpr const char* not_applicable = "not_applicable";

/// Errors up to it are the rounding of ten thousand steps.
constexpr double rounding = 1e-11;

struct Column {
  std::size_t case_index;
  std::string quantity;
};

/// A column a case: its energy where that is kept, else the first that is.
std::vector<Column> columns_of(const ReportData& data) {
  std::map<std::string, std::string> quantity_of;
  for (const DriftRow& row : data.hard_cases.drift.rows)
    if (row.status != not_applicable)
      if (const auto [place, is_new] = quantity_of.try_emplace(row.case_id, row.invariant);
          !is_new && row.invariant == "energy")
        place->second = row.invariant;
  std::vector<Column> columns;
  for (std::size_t i = 0; i < data.cases.size(); ++i)
    if (const auto found = quantity_of.find(data.cases[i].id); found != quantity_of.end())
      columns.push_back({i, found->second});
  return columns;
}

Series series_of(const RowsByPair<DriftRow>& pairs, const std::string& case_id,
                 const std::string& solver, const std::string& quantity) {
  Series series;
  if (const auto found = pairs.find({case_id, solver}); found != pairs.end())
    for (const DriftRow* row : found->second)
      if (row->invariant == quantity) series.push_back(row);
  return series;
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

std::string cell(const Series& series) {
  if (series.empty()) return "<td class=\"not_applicable\">·</td>";
  const DriftRow& last = *series.back();
  double worst = 0;
  for (const DriftRow* row : series) worst = std::fmax(worst, row->relative_error);
  const double power = growth_power(series);
  std::string title =
      fmt::format("step {}, to t = {}: at most {}, at the end {}", show_number(last.step),
                  show_number(last.time), show_number(worst, 2), show_number(last.relative_error));
  if (worst > rounding && !std::isnan(power)) title += fmt::format("; grows as t^{:.1f}", power);
  if (last.status != to_string(Status::ok)) {
    title += fmt::format("; {} {}", last.status, last.detail);
    return fmt::format("<td class=\"failed\" title=\"{}\">✗</td>", escape(title));
  }
  const std::string text =
      worst == 0 ? "0" : fmt::format("{:.0f}", std::floor(std::log10(worst) + 0.5));
  return fmt::format("<td class=\"{}\" title=\"{}\">{}{}</td>", colour_of(worst), escape(title),
                     text, sign_of(worst, power));
}

constexpr const char* text =
    "<p>What is left of a quantity that the exact solution keeps, after ten thousand steps (a "
    "thousand of large systems), each half of that at which the study of orders begins. A cell "
    "is the power of ten of the largest relative error on the way: blue is near rounding, orange "
    "lost. A sign tells how it grows in the last two tenfolds of time: none, it is bounded; ~ as a "
    "root of time, as rounding at random does; ↗ in proportion to time; ⇑ faster. ✗: the run "
    "ended early. In free fall kinetic and potential energy grow without end, and their rounding "
    "with them. Resting on a cell gives the numbers.</p>\n";

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

std::string drift_part(const PageContext& page) {
  const std::vector<Column> columns = columns_of(page.data);
  if (columns.empty()) return {};
  const RowsByPair<DriftRow> pairs = by_pair(page.data.hard_cases.drift.rows);
  std::string head;
  for (const Column& column : columns) {
    const CaseFacts& c = page.data.cases[column.case_index];
    head += fmt::format("<th class=\"turned\"><a href=\"{}\" title=\"{}\">{}{}</a></th>",
                        page.case_address(column.case_index), escape(column.quantity), escape(c.id),
                        column.quantity == "energy" ? "" : ": " + escape(column.quantity));
  }
  std::string diagrams;
  for (const char* id : study::drift_cases_of_peers) diagrams += drift_diagram(page, id, "energy");
  const std::string tables =
      solver_tables(page, "matrix drifts", head, [&](const SolverInfo& solver) {
        std::string html;
        bool any = false;
        for (const Column& column : columns) {
          const Series series =
              series_of(pairs, page.data.cases[column.case_index].id, solver.id(), column.quantity);
          html += cell(series);
          any |= !series.empty();
        }
        return any ? html : std::string();
      });
  return std::string("<h3 id=\"drift\">Drift of energy and invariants</h3>\n") + text +
         (diagrams.empty() ? "" : "<div class=\"speeds\">\n" + diagrams + "</div>\n") + tables;
}

}  // namespace odeum::report
