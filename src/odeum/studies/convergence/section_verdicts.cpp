// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/studies/convergence/section.hpp"

namespace odeum::study {
namespace {

using judge::Verdict;
using report::Cell;
using report::escape;

std::string verdict_table(const std::vector<OrderRow>& orders, Verdict verdict) {
  report::Table table("numbers words");
  table.head({{"solver"}, {"case"}, {"mode"}, {"claimed"}, {"measured"}, {"floor"}, {"reason"}});
  for (const OrderRow& row : orders)
    if (row.fit.verdict == verdict)
      table.row({row.library + "/" + row.solver},
                {{row.case_id},
                 {to_string(row.mode)},
                 {report::show_number(row.claimed_order)},
                 {std::isnan(row.fit.order) ? "–" : fmt::format("{:.2f}", row.fit.order)},
                 {report::show_number(row.fit.floor)},
                 {.text = row.fit.reason, .style = "reason"}});
  if (table.rows() == 0) return fmt::format("<p>{} none</p>\n", report::verdict_chip(verdict));
  return report::details(
      report::verdict_chip(verdict) + " " + report::show_count(table.rows(), "pair"), table.html());
}

/// Names that share a reason: their number, and all of them when opened.
Cell names(const std::set<std::string>& list, const char* noun) {
  std::string all;
  for (const std::string& name : list) all += (all.empty() ? "" : ", ") + escape(name);
  if (list.size() > 3) all = report::details(report::show_count(list.size(), noun), all);
  return {.markup = all};
}

struct Group {
  std::size_t rows = 0;
  std::set<std::string> solvers, cases;
  std::string detail;  ///< of the first row
};

/// Rows by library and `what(row)`; those for which that is empty are left out.
template <class Row, class What, class Detail>
std::map<std::pair<std::string, std::string>, Group> groups_of(const std::vector<Row>& rows,
                                                               What&& what, Detail&& detail) {
  std::map<std::pair<std::string, std::string>, Group> groups;
  for (const Row& row : rows) {
    const std::string shared = what(row);
    if (shared.empty()) continue;
    Group& group = groups[{row.library, shared}];
    if (group.rows++ == 0) group.detail = detail(row);
    group.solvers.insert(row.solver);
    group.cases.insert(row.case_id);
  }
  return groups;
}

std::string unfit_table(const std::vector<OrderRow>& orders) {
  report::Table table("numbers words");
  table.head({{"library"}, {"reason"}, {"pairs"}, {"solvers"}, {"cases"}});
  const auto reason = [](const OrderRow& row) {
    return row.fit.verdict == Verdict::not_applicable ? row.fit.reason : std::string();
  };
  for (const auto& [key, group] : groups_of(orders, reason, reason))
    table.row({key.first}, {{.text = key.second, .style = "reason"},
                            {std::to_string(group.rows)},
                            names(group.solvers, "solver"),
                            names(group.cases, "case")});
  return table.rows() == 0 ? "<p>Every solver fits every case.</p>\n" : table.html();
}

std::string early_ends_table(const std::vector<ConvergenceRow>& rows) {
  report::Table table("numbers words");
  table.head({{"library"}, {"status"}, {"runs"}, {"solvers"}, {"cases"}, {"detail of the first"}});
  const auto status = [](const ConvergenceRow& row) {
    return row.status == "ok" || row.status == "not_applicable" ? std::string() : row.status;
  };
  const auto detail = [](const ConvergenceRow& row) { return row.detail; };
  for (const auto& [key, group] : groups_of(rows, status, detail))
    table.row({key.first}, {{.markup = "<code>" + escape(key.second) + "</code>"},
                            {std::to_string(group.rows)},
                            names(group.solvers, "solver"),
                            names(group.cases, "case"),
                            {.text = group.detail, .style = "reason"}});
  return table.rows() == 0 ? "<p>Every run reached the end.</p>\n" : table.html();
}

}  // namespace

void add_verdicts(report::Page& page, const ConvergenceResult& result) {
  std::string open =
      "<p>Every pair whose order is lower than claimed, stops falling, could not be determined, or "
      "failed, with the reason. What was investigated stands under <a href=\"#findings\">Findings"
      "</a>.</p>\n";
  for (const Verdict verdict :
       {Verdict::lower, Verdict::floors, Verdict::failed, Verdict::undetermined})
    open += verdict_table(result.orders, verdict);
  page.section({.id = "verdicts", .title = "What did not confirm", .place = 900, .html = open});
  std::string skipped;
  for (const LibraryInfo& info : page.facts().libraries)
    if (!info.built)
      skipped += fmt::format("<p>Not built in: <strong>{}</strong> (option <code>{}</code>).</p>\n",
                             escape(info.name), escape(info.option));
  page.section({.id = "skipped",
                .title = "What was skipped, and what ended early",
                .place = 910,
                .html = skipped + "<h3>Without an order to judge</h3>\n" +
                        unfit_table(result.orders) + "<h3>Runs that ended early</h3>\n" +
                        early_ends_table(result.rows),
                .short_title = "Skipped"});
}

}  // namespace odeum::study
