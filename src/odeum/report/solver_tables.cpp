// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/solver_tables.hpp"

#include <fmt/format.h>

#include "odeum/report/html.hpp"

namespace odeum::report {
namespace {

std::string description(const SolverInfo& solver) {
  std::string text = solver.family;
  if (!solver.controller.empty()) text += ". " + solver.controller;
  if (!solver.needs.empty()) text += ". Needs " + solver.needs;
  if (!solver.source.empty()) text += ". " + solver.source;
  return text;
}

}  // namespace

std::string solver_tables(const Facts& facts, const std::string& style,
                          const std::vector<Cell>& head,
                          const std::function<std::vector<Cell>(const SolverInfo&)>& cells,
                          bool open) {
  std::vector<Cell> whole_head{{.text = "solver", .style = "corner"}};
  whole_head.insert(whole_head.end(), head.begin(), head.end());
  std::string html;
  for (const std::string& library : facts.library_names()) {
    Table table(style);
    table.head(whole_head);
    for (const SolverInfo& solver : facts.solvers) {
      if (solver.library != library) continue;
      if (const std::vector<Cell> row = cells(solver); !row.empty())
        table.row({.text = solver.method, .title = description(solver)}, row);
    }
    html += details(
        fmt::format("<strong>{}</strong> {} <span class=\"dim\">{}</span>", escape(library),
                    escape(facts.library_version(library)), show_count(table.rows(), "solver")),
        table.html(), open && library == "odeum");
  }
  return html;
}

Cell case_head(const CaseFacts& c, const std::string& more) {
  return {.style = "turned",
          .markup = fmt::format("<a href=\"{}\">{}</a>", as_address(c.file), escape(c.id + more))};
}

}  // namespace odeum::report
