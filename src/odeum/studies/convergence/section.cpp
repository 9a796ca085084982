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
  const judge::OrderFit& fit = row.fit;
  std::string text = to_string(fit.verdict);
  if (!std::isnan(fit.order))
    text +=
        fmt::format(": measured {:.2f} [{:.2f}, {:.2f}] over {}, claimed {}", fit.order, fit.low,
                    fit.high, show_count(fit.points, "point"), show_number(row.claimed_order));
  if (!fit.reason.empty()) text += ". " + fit.reason;
  return text;
}

// A cell is a sign wide, so that every case has room on a screen: the order to the nearest whole
// number where it is confirmed, else the verdict's sign. The title holds the rest; why a solver
// does not fit is told once, under "skipped", not in thousands of titles.
std::string cell(const study::OrderRow* row) {
  if (!row) return "<td></td>";
  const judge::Verdict verdict = row->fit.verdict;
  const bool confirmed = verdict == judge::Verdict::confirmed;
  const std::string text = confirmed && !std::isnan(row->fit.order)
                               ? fmt::format("{:.0f}", row->fit.order)
                               : style_of(verdict).glyph;
  const std::string title = verdict == judge::Verdict::not_applicable
                                ? std::string("does not apply")
                                : escape(cell_title(*row));
  return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", to_string(verdict), title, text);
}

std::string heading(const PageContext& page) {
  std::string html = "<thead><tr><th class=\"corner\">solver</th><th class=\"claim\">claimed</th>";
  for (std::size_t i = 0; i < page.data.cases.size(); ++i)
    html += fmt::format("<th class=\"turned\"><a href=\"{}\">{}</a></th>", page.case_address(i),
                        escape(page.data.cases[i].id));
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
      "<details{}><summary><strong>{}</strong> {} <span class=\"dim\">{}</span></summary>\n"
      "<div class=\"wide\"><table "
      "class=\"matrix\">\n{}<tbody>\n{}</tbody></table></div></details>\n",
      library == "odeum" && mode == Mode::fixed ? " open" : "", escape(library),
      escape(library_version(page.data, library)), show_count(count, "solver"), heading(page),
      rows);
}

}  // namespace

std::string orders_section(const PageContext& page) {
  std::string html =
      "<section id=\"orders\">\n<h2>Orders, solver by solver</h2>\n<p>The measured order of every "
      "solver on every case. A number, the order to the nearest whole one, confirms the claim; any "
      "other sign says what became of it. Resting on a cell gives the order in full, its interval "
      "and the reason; the page of a case has them as a table.</p>\n";
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
