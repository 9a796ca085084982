// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "odeum/report/html.hpp"
#include "odeum/report/solver_groups.hpp"
#include "odeum/studies/convergence/section.hpp"

namespace odeum::study {
namespace {

using judge::Verdict;
using report::Cell;
using report::SolverGroup;

/// Verdicts by case (empty: all of them) and group of solvers.
using Tally = std::map<std::pair<std::string, std::string>, VerdictCounts>;

Tally tally_of(const std::vector<SolverGroup>& groups, const std::vector<OrderRow>& orders) {
  std::map<std::string, std::string> group_of;
  for (const SolverGroup& group : groups)
    for (const SolverInfo* solver : group.solvers) group_of[solver->id()] = group.title;
  Tally tally;
  for (const OrderRow& row : orders)
    if (const auto group = group_of.find(row.library + "/" + row.solver); group != group_of.end())
      for (const std::string& case_id : {row.case_id, std::string()})
        ++of(tally[{case_id, group->second}], row.fit.verdict);
  return tally;
}

Cell cell_of(VerdictCounts& counts, const SolverGroup& group) {
  std::size_t judged = 0;
  for (const std::size_t count : counts) judged += count;
  judged -= of(counts, Verdict::not_applicable);
  if (judged == 0) return {.text = "·", .style = "zero", .title = "does not apply"};
  return {
      .title = group.title + ": " + verdict_words(counts),
      .markup = fmt::format("{}<b>{}</b>/{}", verdict_bar(counts),
                            of(counts, Verdict::confirmed) + of(counts, Verdict::higher), judged)};
}

// Own families first, then the peers, under a line that says which is which.
void add_head(report::Table& table, const std::vector<SolverGroup>& groups) {
  const auto own = static_cast<std::size_t>(
      std::count_if(groups.begin(), groups.end(), [](const auto& group) { return group.own; }));
  std::vector<Cell> kinds{{.text = "case", .rows = 2}}, titles;
  if (own > 0) kinds.push_back({.text = "Odeum, by family", .columns = own});
  if (own < groups.size())
    kinds.push_back({.text = "peers, by library", .columns = groups.size() - own});
  for (const SolverGroup& group : groups)
    titles.push_back(
        {.markup = fmt::format("{}<br><span class=\"dim\">{}</span>", report::escape(group.title),
                               report::show_count(group.solvers.size(), "solver"))});
  table.head(kinds);
  table.head(titles);
}

constexpr const char* text =
    "<p>How many pairs of a solver and a mode show the claimed order, or a higher one, of those "
    "that can be judged; the bar has all verdicts. Red is no wrong solver but one without a "
    "solution at any step tried, as explicit methods on stiff cases; pale violet is too little for "
    "a "
    "verdict within the budget (<a href=\"verdicts.html\">by class</a>). Each case has a page of "
    "its own with its equation, plots and orders.</p>\n";

template <class Of>
void each_verdict(const VerdictCounts& counts, Of&& each) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (const Verdict verdict = report::verdict_styles[i].verdict;
        counts[i] > 0 && verdict != Verdict::not_applicable)
      each(counts[i], to_string(verdict));
}

}  // namespace

std::string verdict_bar(const VerdictCounts& counts) {
  std::string bar;
  each_verdict(counts, [&](std::size_t count, const std::string& name) {
    bar += fmt::format("<i class=\"{}\" style=\"flex-grow:{}\"></i>", name, count);
  });
  return "<span class=\"bar\" aria-hidden=\"true\">" + bar + "</span>";
}

std::string verdict_words(const VerdictCounts& counts) {
  std::string words;
  each_verdict(counts, [&](std::size_t count, const std::string& name) {
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, name);
  });
  return words.empty() ? "not run" : words;
}

std::string overview(const report::Facts& facts, const std::vector<OrderRow>& orders) {
  const std::vector<SolverGroup> groups = report::make_groups(facts.solvers);
  Tally tally = tally_of(groups, orders);
  report::Table table("overview");
  add_head(table, groups);
  const auto add = [&](const Cell& name, const std::string& case_id, const char* style) {
    std::vector<Cell> cells;
    for (const SolverGroup& group : groups)
      cells.push_back(cell_of(tally[{case_id, group.title}], group));
    table.row(name, cells, style);
  };
  add({"all cases"}, "", "all");
  std::string cloths, others;
  for (const report::CaseFacts& c : facts.cases) {
    if (!is_measured(orders, c.id)) {
      others += (others.empty() ? "" : ", ") + report::case_link(c);
      continue;
    }
    add({.markup = report::case_link(c) + "<span>" + report::escape(c.title) + "</span>"}, c.id,
        "");
    if (c.has_tag("cloth")) cloths += (cloths.empty() ? "" : ", ") + report::case_link(c, "time");
  }
  if (!cloths.empty())
    cloths =
        "<p>The pages of the cloths also show errors and energy over time: " + cloths + ".</p>\n";
  if (!others.empty()) others = "<p class=\"dim\">Not tried in this report: " + others + ".</p>\n";
  return text + table.html() + cloths + others;
}

}  // namespace odeum::study
