// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/report/summary.hpp"

namespace odeum::report {
namespace {

std::string cell_title(const study::OrderRow& row) {
  const study::OrderFit& fit = row.fit;
  std::string text = study::to_string(fit.verdict);
  if (!std::isnan(fit.order))
    text +=
        fmt::format(": measured {:.2f} [{:.2f}, {:.2f}] over {}, claimed {}", fit.order, fit.low,
                    fit.high, show_count(fit.points, "point"), show_number(row.claimed_order));
  if (!fit.reason.empty()) text += ". " + fit.reason;
  return text;
}

std::string cell(const study::OrderRow* row) {
  if (!row) return "<td></td>";
  const bool has_order = !std::isnan(row->fit.order);
  const bool confirmed = row->fit.verdict == study::Verdict::confirmed;
  std::string text = has_order ? fmt::format("{:.2f}", row->fit.order) : std::string();
  if (!confirmed || !has_order) text += fmt::format("<i>{}</i>", style_of(row->fit.verdict).glyph);
  return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", study::to_string(row->fit.verdict),
                     escape(cell_title(*row)), text);
}

std::string heading(const ReportData& data) {
  std::string html = "<thead><tr><th class=\"corner\">solver</th><th>claimed</th>";
  for (std::size_t i = 0; i < data.cases.size(); ++i)
    html += fmt::format("<th class=\"turned\"><a href=\"#{}\">{}</a></th>", case_anchor(i),
                        escape(data.cases[i].id));
  return html + "</tr></thead>\n";
}

std::string solver_row(const PageContext& page, const SolverInfo& solver, Mode mode) {
  std::string title = solver.family;
  for (const std::string* more : {&solver.controller, &solver.needs, &solver.source})
    if (!more->empty()) title += (more == &solver.needs ? ". Needs " : ". ") + *more;
  std::string html = fmt::format("<tr><th title=\"{}\">{}</th><td class=\"claimed\">{}</td>",
                                 escape(title), escape(solver.method),
                                 std::isnan(solver.order) ? "varies" : show_number(solver.order));
  for (const CaseFacts& c : page.data.cases) html += cell(page.lookup.order(c.id, solver, mode));
  return html + "</tr>\n";
}

std::string matrix(const PageContext& page, const std::string& library, Mode mode) {
  std::string rows;
  std::size_t count = 0;
  for (const SolverInfo& solver : page.data.solvers) {
    if (solver.library != library || !(mode == Mode::fixed ? solver.fixed : solver.adaptive))
      continue;
    rows += solver_row(page, solver, mode);
    ++count;
  }
  if (count == 0) return {};
  return fmt::format(
      "<details open><summary><strong>{}</strong> {} <span class=\"dim\">{}</span></summary>\n"
      "<div class=\"wide\"><table "
      "class=\"matrix\">\n{}<tbody>\n{}</tbody></table></div></details>\n",
      escape(library), escape(library_version(page.data, library)), show_count(count, "solver"),
      heading(page.data), rows);
}

}  // namespace

std::string overview_section(const PageContext& page) {
  std::string html =
      "<section id=\"overview\">\n<h2>Overview</h2>\n<p>The measured order of every solver on "
      "every "
      "case. A plain number confirms the claim; the sign behind any other says what became of it, "
      "and resting on a cell tells why.</p>\n";
  for (const Mode mode : {Mode::fixed, Mode::adaptive}) {
    html += mode == Mode::fixed
                ? "<h3>At a fixed step</h3>\n"
                : "<h3>At a step of the solver's own choice</h3>\n<p>The order here is the slope "
                  "against the mean step as the tolerance falls: a looser yardstick.</p>\n";
    for (const std::string& library : library_names(page.data)) html += matrix(page, library, mode);
  }
  return html + "</section>\n";
}

}  // namespace odeum::report
