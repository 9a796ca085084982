// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/report/solver_groups.hpp"

namespace odeum::report {
namespace {

/// Verdicts by case and group of solvers.
class Tally {
 public:
  Tally(const ReportData& data, const std::vector<SolverGroup>& groups)
      : groups_(groups.size()), counts_(data.cases.size() * groups.size()), all_(groups.size()) {
    std::map<std::string, std::size_t> case_of, group_of;
    for (std::size_t i = 0; i < data.cases.size(); ++i) case_of[data.cases[i].id] = i;
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const SolverInfo* solver : groups[g].solvers) group_of[solver->id()] = g;
    for (const study::OrderRow& row : data.convergence.orders) {
      const auto c = case_of.find(row.case_id);
      const auto g = group_of.find(row.library + "/" + row.solver);
      if (c == case_of.end() || g == group_of.end()) continue;
      const auto verdict = static_cast<std::size_t>(row.fit.verdict);
      ++counts_[c->second * groups_ + g->second][verdict];
      ++all_[g->second][verdict];
    }
  }
  const VerdictCounts& of(std::size_t case_index, std::size_t group) const {
    return counts_[case_index * groups_ + group];
  }
  const VerdictCounts& all(std::size_t group) const { return all_[group]; }

 private:
  std::size_t groups_;
  std::vector<VerdictCounts> counts_;
  std::vector<VerdictCounts> all_;
};

std::string cell(const VerdictCounts& counts, const SolverGroup& group) {
  std::size_t judged = 0;
  for (const VerdictStyle& style : verdict_styles)
    if (style.verdict != judge::Verdict::not_applicable)
      judged += counts[static_cast<std::size_t>(style.verdict)];
  if (judged == 0) return "<td class=\"zero\" title=\"does not apply\">·</td>";
  const std::size_t good = counts[static_cast<std::size_t>(judge::Verdict::confirmed)] +
                           counts[static_cast<std::size_t>(judge::Verdict::higher)];
  return fmt::format("<td title=\"{}: {}\">{}<b>{}</b>/{}</td>", escape(group.title),
                     verdict_words(counts), verdict_bar(counts), good, judged);
}

// Own families first, then the peers, under a line that says which is which.
std::string heading(const std::vector<SolverGroup>& groups) {
  const auto own =
      std::count_if(groups.begin(), groups.end(), [](const auto& group) { return group.own; });
  const auto peers = static_cast<std::ptrdiff_t>(groups.size()) - own;
  std::string html = "<thead><tr><th rowspan=\"2\">case</th>";
  if (own) html += fmt::format("<th colspan=\"{}\">Odeum, by family</th>", own);
  if (peers) html += fmt::format("<th colspan=\"{}\">peers, by library</th>", peers);
  html += "</tr><tr>";
  for (const SolverGroup& group : groups)
    html += fmt::format("<th>{}<br><span class=\"dim\">{}</span></th>", escape(group.title),
                        show_count(group.solvers.size(), "solver"));
  return html + "</tr></thead>\n";
}

std::string cloth_links(const PageContext& page) {
  std::string links;
  for (std::size_t i = 0; i < page.data.cases.size(); ++i)
    if (page.data.cases[i].has_tag("cloth"))
      links += fmt::format("{}<a href=\"{}#time\">{}</a>", links.empty() ? "" : ", ",
                           page.case_address(i), escape(page.data.cases[i].id));
  if (links.empty()) return {};
  return "<p>The pages of the cloths also show errors and energy in the course of time: " + links +
         ".</p>\n";
}

}  // namespace

std::string overview_section(const PageContext& page) {
  const std::vector<SolverGroup> groups = make_groups(page.data.solvers);
  const Tally tally(page.data, groups);
  std::string html =
      "<section id=\"overview\">\n<h2>Overview</h2>\n<p>How many pairs of a solver and a mode show "
      "the order that is claimed, or a higher one, of those that can be judged; the bar has all "
      "verdicts. Each case has a page of its own with its equation, plots and orders.</p>\n"
      "<table class=\"overview\">\n" +
      heading(groups) + "<tbody>\n<tr class=\"all\"><th>all cases</th>";
  for (std::size_t g = 0; g < groups.size(); ++g) html += cell(tally.all(g), groups[g]);
  html += "</tr>\n";
  for (std::size_t i = 0; i < page.data.cases.size(); ++i) {
    const CaseFacts& c = page.data.cases[i];
    html += fmt::format("<tr><th><a href=\"{}\"><code>{}</code></a><span>{}</span></th>",
                        page.case_address(i), escape(c.id), escape(c.title));
    for (std::size_t g = 0; g < groups.size(); ++g) html += cell(tally.of(i, g), groups[g]);
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n" + cloth_links(page) + "</section>\n";
}

}  // namespace odeum::report
