// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/hard_cases/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"

namespace odeum::report {
namespace {

template <std::size_t N>
std::string names(const char* const (&ids)[N]) {
  std::string text;
  for (const char* id : ids)
    text += fmt::format("{}<code>{}</code>", text.empty() ? "" : ", ", escape(id));
  return text;
}

// What was run: the rule, in words.
std::string selection() {
  return fmt::format(
      "<p>To keep a report short: Odeum's own solvers on every case of these studies, peers on {} "
      "(drift) and {} (largest step), for the horizons all but <code>{}</code>'s, and every solver "
      "for the order. <code>odeum drift</code>, <code>odeum limits</code> and <code>odeum "
      "reduction</code> with this folder as <code>--out</code> run every pair, and the next report "
      "shows those too.</p>\n",
      names(study::drift_cases_of_peers), names(study::limit_cases_of_peers),
      study::library_without_horizons);
}

}  // namespace

std::string solver_tables(const PageContext& page, const std::string& style,
                          const std::string& head,
                          const std::function<std::string(const SolverInfo&)>& cells) {
  std::string html;
  for (const std::string& library : library_names(page.data)) {
    std::string rows;
    std::size_t count = 0;
    for (const SolverInfo& solver : page.data.solvers) {
      if (solver.library != library) continue;
      const std::string row = cells(solver);
      if (row.empty()) continue;
      rows += fmt::format("<tr><th title=\"{}\">{}</th>{}</tr>\n", escape(solver.family),
                          escape(solver.method), row);
      ++count;
    }
    if (count == 0) continue;
    html += fmt::format(
        "<details{}><summary><strong>{}</strong> <span class=\"dim\">{}</span></summary>\n<div "
        "class=\"wide\"><table class=\"{}\"><thead><tr><th class=\"corner\">solver</th>{}</tr>"
        "</thead><tbody>\n{}</tbody></table></div></details>\n",
        library == "odeum" ? " open" : "", escape(library), show_count(count, "solver"), style,
        head, rows);
  }
  return html;
}

bool is_symplectic(const ReportData& data, const SolverInfo& solver) {
  if (solver.family == "symplectic") return true;
  return solver.library == "odeum" && std::any_of(data.proofs.rows.begin(), data.proofs.rows.end(),
                                                  [&](const study::ProofRow& row) {
                                                    return row.method == solver.method &&
                                                           row.symplectic();
                                                  });
}

std::string hard_cases_section(const PageContext& page) {
  const study::HardCaseResults& hard = page.data.hard_cases;
  std::string html = "<section id=\"hard\">\n<h2>Stability and long runs on hard cases</h2>\n";
  if (!hard.problem.empty())
    html += fmt::format("<p class=\"missing\">{}</p>\n", escape(hard.problem));
  if (hard.empty())
    return html +
           "<p>Not measured in this run: a full <code>odeum report</code> runs a selection, "
           "<code>odeum drift</code>, <code>odeum limits</code> and <code>odeum reduction</code> "
           "into the same folder everything.</p>\n</section>\n";
  html += hard.measured ? selection()
                        : "<p>Not measured in this run: these are results of an earlier one, which "
                          "the folder held.</p>\n";
  html += reduction_part(page) + largest_steps_part(page) + drift_part(page) +
          oscillator_part(page) + horizons_part(page);
  return html + "</section>\n";
}

}  // namespace odeum::report
