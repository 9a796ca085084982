// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/markdown.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/report/summary.hpp"
#include "odeum/report/texts.hpp"

namespace odeum::report {
namespace {

using judge::Verdict;
using study::OrderRow;

std::string verdict_rows(const ReportData& data, Verdict verdict, std::size_t& count) {
  std::string html;
  for (const OrderRow& row : data.convergence.orders) {
    if (row.fit.verdict != verdict) continue;
    ++count;
    html += fmt::format(
        "<tr><th>{}/{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td class=\"reason\">{}</td></tr>\n",
        escape(row.library), escape(row.solver), escape(row.case_id), to_string(row.mode),
        show_number(row.claimed_order),
        std::isnan(row.fit.order) ? "–" : fmt::format("{:.2f}", row.fit.order),
        show_number(row.fit.floor), escape(row.fit.reason));
  }
  return html;
}

/// Names that share a reason, shown as their number, and in full when opened.
std::string names(const std::set<std::string>& list, const char* noun) {
  std::string all;
  for (const std::string& name : list) all += (all.empty() ? "" : ", ") + escape(name);
  if (list.size() <= 3) return all;
  return fmt::format("<details><summary>{}</summary>{}</details>", show_count(list.size(), noun),
                     all);
}

struct Group {
  std::size_t rows = 0;
  std::set<std::string> solvers, cases;
  std::string detail;  ///< of the first row
  void add(const std::string& solver, const std::string& case_id, const std::string& text) {
    if (rows++ == 0) detail = text;
    solvers.insert(solver);
    cases.insert(case_id);
  }
};

using Groups = std::map<std::pair<std::string, std::string>, Group>;  // by library and what

std::string unfit_table(const ReportData& data) {
  Groups groups;
  for (const OrderRow& row : data.convergence.orders)
    if (row.fit.verdict == Verdict::not_applicable)
      groups[{row.library, row.fit.reason}].add(row.solver, row.case_id, row.fit.reason);
  std::string rows;
  for (const auto& [key, group] : groups)
    rows += fmt::format(
        "<tr><th>{}</th><td class=\"reason\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        escape(key.first), escape(key.second), group.rows, names(group.solvers, "solver"),
        names(group.cases, "case"));
  if (rows.empty()) return "<p>Every solver fits every case.</p>\n";
  return "<div class=\"wide\"><table class=\"numbers "
         "words\"><thead><tr><th>library</th><th>reason</th>"
         "<th>pairs</th><th>solvers</th><th>cases</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string early_ends_table(const ReportData& data) {
  Groups groups;
  for (const study::ConvergenceRow& row : data.convergence.rows)
    if (row.status != "ok" && row.status != "not_applicable")
      groups[{row.library, row.status}].add(row.solver, row.case_id, row.detail);
  std::string rows;
  for (const auto& [key, group] : groups)
    rows += fmt::format(
        "<tr><th>{}</th><td><code>{}</code></td><td>{}</td><td>{}</td><td>{}</td>"
        "<td class=\"reason\">{}</td></tr>\n",
        escape(key.first), escape(key.second), group.rows, names(group.solvers, "solver"),
        names(group.cases, "case"), escape(group.detail));
  if (rows.empty()) return "<p>Every run reached the end.</p>\n";
  return "<div class=\"wide\"><table class=\"numbers "
         "words\"><thead><tr><th>library</th><th>status</th>"
         "<th>runs</th><th>solvers</th><th>cases</th><th>the first "
         "says</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

}  // namespace

std::string verdicts_section(const PageContext& page) {
  std::string html =
      "<section id=\"verdicts\">\n<h2>What did not confirm</h2>\n<p>Every pair whose order came "
      "out "
      "lower than claimed, stops falling, could not be told, or failed, with the reason. What was "
      "looked into stands under <a href=\"#findings\">Findings</a>.</p>\n";
  for (const Verdict verdict :
       {Verdict::lower, Verdict::floors, Verdict::failed, Verdict::undetermined}) {
    std::size_t count = 0;
    const std::string rows = verdict_rows(page.data, verdict, count);
    if (count == 0) {
      html += fmt::format("<p>{} none</p>\n", verdict_chip(verdict));
      continue;
    }
    html += fmt::format(
        "<details><summary>{} {}</summary><div class=\"wide\"><table class=\"numbers "
        "words\"><thead>"
        "<tr><th>solver</th><th>case</th><th>mode</th><th>claimed</th><th>measured</th><th>floor</"
        "th>"
        "<th>reason</th></tr></thead><tbody>\n{}</tbody></table></div></details>\n",
        verdict_chip(verdict), show_count(count, "pair"), rows);
  }
  return html + "</section>\n";
}

std::string skipped_section(const PageContext& page) {
  std::string html = "<section id=\"skipped\">\n<h2>What was skipped, and what ended early</h2>\n";
  for (const LibraryInfo& info : page.data.libraries)
    if (!info.built)
      html += fmt::format("<p>Not built in: <strong>{}</strong> (option <code>{}</code>).</p>\n",
                          escape(info.name), escape(info.option));
  return html + "<h3>Without an order to judge</h3>\n" + unfit_table(page.data) +
         "<h3>Runs that ended early</h3>\n" + early_ends_table(page.data) + "</section>\n";
}

std::string findings_section() {
  return "<section id=\"findings\" class=\"prose\">\n" + markdown_to_html(findings()) +
         "</section>\n";
}

}  // namespace odeum::report
