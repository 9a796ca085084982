// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
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

/// The classes of reasons of a verdict, and what would give an order.
std::string classes_table(const std::vector<OrderRow>& orders, Verdict verdict) {
  std::map<std::string_view, Group> groups;
  for (const OrderRow& row : orders) {
    const OrderClass* const found = row.fit.verdict == verdict ? class_of(row.fit) : nullptr;
    if (!found) continue;
    Group& group = groups[found->name];
    ++group.rows;
    group.solvers.insert(row.library + "/" + row.solver);
    group.cases.insert(row.case_id);
    group.detail = found->settles;
  }
  report::Table table("numbers words");
  table.head({{"class"}, {"pairs"}, {"what would give an order"}, {"solvers"}, {"cases"}});
  for (const auto& [name, group] : groups)
    table.row({std::string(name)}, {{std::to_string(group.rows)},
                                    {.text = group.detail, .style = "reason"},
                                    names(group.solvers, "solver"),
                                    names(group.cases, "case")});
  return table.rows() == 0 ? std::string() : table.html();
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

/// Runs to a tolerance whose answer is wrong, by solver and case; empty where there are none.
std::string wrong_answers_table(const std::vector<const ConvergenceRow*>& rows) {
  std::map<std::pair<std::string, std::string>, std::vector<const ConvergenceRow*>> wrong;
  for (const ConvergenceRow* row : rows)
    if (row->mode == Mode::adaptive && row->judged.answer == judge::Answer::wrong)
      wrong[{row->library + "/" + row->solver, row->case_id}].push_back(row);
  if (wrong.empty()) return {};
  report::Table table("numbers words");
  table.head({{"solver"}, {"case"}, {"tolerances"}, {"error of the first"}, {"reason"}});
  for (const auto& [key, runs] : wrong) {
    std::string tolerances;
    for (const ConvergenceRow* run : runs)
      tolerances += fmt::format("{}{:.0e}", tolerances.empty() ? "" : ", ", run->tolerance);
    table.row({key.first}, {{key.second},
                            {tolerances},
                            {report::show_number(runs.front()->error_max)},
                            {.text = runs.front()->judged.reason, .style = "reason"}});
  }
  return table.html();
}

std::string diverged_table(const std::vector<ConvergenceRow>& rows) {
  report::Table table("numbers words");
  table.head({{"library"}, {"runs"}, {"solvers"}, {"cases"}, {"reason of the first"}});
  const auto diverged = [](const ConvergenceRow& row) {
    const bool wrong = row.mode == Mode::fixed && row.judged.answer == judge::Answer::wrong;
    return wrong ? std::string("wrong") : std::string();
  };
  const auto reason = [](const ConvergenceRow& row) { return row.judged.reason; };
  for (const auto& [key, group] : groups_of(rows, diverged, reason))
    table.row({key.first}, {{std::to_string(group.rows)},
                            names(group.solvers, "solver"),
                            names(group.cases, "case"),
                            {.text = group.detail, .style = "reason"}});
  return table.rows() == 0 ? "<p>No run that ended ok has diverged.</p>\n" : table.html();
}

std::string answers_html(const ConvergenceResult& result) {
  std::vector<const ConvergenceRow*> all;
  for (const ConvergenceRow& row : result.rows) all.push_back(&row);
  const std::string wrong = wrong_answers_table(all);
  return "<p>A run that ends <code>ok</code> claims an answer. To a tolerance it is wrong where "
         "its "
         "error exceeds what the tolerance, the number of steps and the amplification of errors by "
         "the case (from its fundamental matrix) explain; at a fixed step, which promises no "
         "error, "
         "where it is ten times the solution's size; in either case past the end of the solution."
         "</p>\n<h3>To a tolerance</h3>\n" +
         (wrong.empty() ? "<p>No answer is wrong.</p>\n" : wrong) + "<h3>At a fixed step</h3>\n" +
         diverged_table(result.rows);
}

/// How many answers of runs to a tolerance are what, for the page of a case.
void add_answers_of_cases(report::Page& page, const ConvergenceResult& result) {
  std::map<std::string, std::vector<const ConvergenceRow*>> by_case;
  for (const ConvergenceRow& row : result.rows)
    if (row.mode == Mode::adaptive && row.status != "not_applicable")
      by_case[row.case_id].push_back(&row);
  for (std::size_t i = 0; i < page.facts().cases.size(); ++i) {
    const auto& rows = by_case[page.facts().cases[i].id];
    if (rows.empty()) continue;
    std::string counts;
    for (const judge::Answer answer : {judge::Answer::explained, judge::Answer::wrong,
                                       judge::Answer::undetermined, judge::Answer::none}) {
      const auto count = std::count_if(rows.begin(), rows.end(), [&](const ConvergenceRow* row) {
        return row->judged.answer == answer;
      });
      if (count > 0)
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, to_string(answer));
    }
    page.case_fact(i, "Answers to a tolerance", counts);
    if (const std::string table = wrong_answers_table(rows); !table.empty())
      page.case_part(
          i,
          {.id = "answers", .title = "Wrong answers to a tolerance", .place = 50, .html = table});
  }
}

}  // namespace

void add_verdicts(report::Page& page, const ConvergenceResult& result) {
  std::string open =
      "<p>Every pair without a confirmed order, by class, with the reason. A pair that failed or "
      "is "
      "undetermined is no wrong solver: most were given steps that are too large for it, or too "
      "few evaluations. What was investigated stands under <a "
      "href=\"findings.html\">Findings"
      "</a>.</p>\n";
  for (const Verdict verdict :
       {Verdict::lower, Verdict::floors, Verdict::failed, Verdict::undetermined})
    open += verdict_table(result.orders, verdict) + classes_table(result.orders, verdict);
  page.section({.id = "verdicts", .title = "What did not confirm", .place = 900, .html = open});
  page.section({.id = "answers",
                .title = "Runs that ended ok with a wrong answer",
                .place = 905,
                .html = answers_html(result),
                .short_title = "Wrong answers"});
  add_answers_of_cases(page, result);
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
