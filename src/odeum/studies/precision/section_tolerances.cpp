// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/report/solver_groups.hpp"

namespace odeum::report {
namespace {

using study::PrecisionRow;
/// log10 of achieved over requested, by what was requested.
using Misses = std::map<double, std::vector<double>, std::greater<>>;

// A colour for each factor of ten that an error is off; both ends are open.
std::string colour_of(double decades) {
  const int level = static_cast<int>(std::clamp(std::floor(decades + 0.5), -3.0, 3.0));
  return level < 0 ? fmt::format("t-{}", -level) : fmt::format("t{}", level);
}

std::string cell(std::vector<double> decades) {
  if (decades.empty()) return "<td class=\"zero\">·</td>";
  std::sort(decades.begin(), decades.end());
  const double median = decades[decades.size() / 2];
  const double shown = std::abs(median) < 0.05 ? 0 : median;  // no "-0.0"
  const std::string title =
      decades.size() == 1
          ? fmt::format("achieved / requested = {:.2g}", std::pow(10, median))
          : fmt::format("achieved / requested: median {:.2g} of {} solvers, from {:.2g} to {:.2g}",
                        std::pow(10, median), decades.size(), std::pow(10, decades.front()),
                        std::pow(10, decades.back()));
  return fmt::format("<td class=\"{}\" title=\"{}\">{:+.1f}</td>", colour_of(median), title, shown);
}

std::string row_html(const std::string& name, Misses& misses, const std::set<double>& tolerances) {
  std::string html = "<tr><th>" + escape(name) + "</th>";
  for (auto t = tolerances.rbegin(); t != tolerances.rend(); ++t) html += cell(misses[*t]);
  return html + "</tr>\n";
}

}  // namespace

std::string tolerance_table(const PageContext& page, const std::vector<PrecisionRow>& rows,
                            bool each_solver) {
  std::set<double> tolerances;
  std::map<std::string, Misses> by_solver;
  for (const PrecisionRow& row : rows) {
    if (row.mode != Mode::adaptive || row.status != to_string(Status::ok)) continue;
    if (!(row.error > 0 && row.setting > 0)) continue;
    tolerances.insert(row.setting);
    by_solver[row.library + "/" + row.solver][row.setting].push_back(
        std::log10(row.error / row.setting));
  }
  if (by_solver.empty()) return {};
  std::string groups, solvers;
  for (const SolverGroup& group : make_groups(page.data.solvers)) {
    Misses all;
    for (const SolverInfo* solver : group.solvers) {
      const auto found = by_solver.find(solver->id());
      if (found == by_solver.end()) continue;
      for (const auto& [tolerance, decades] : found->second)
        all[tolerance].insert(all[tolerance].end(), decades.begin(), decades.end());
      if (each_solver) solvers += row_html(solver->id(), found->second, tolerances);
    }
    if (!all.empty())
      groups += row_html(group.own ? "odeum: " + group.title : group.title, all, tolerances);
  }
  std::string head = "<thead><tr><th>requested</th>";
  for (auto t = tolerances.rbegin(); t != tolerances.rend(); ++t)
    head += fmt::format("<th>{:.0e}</th>", *t);
  head += "</tr></thead>";
  const auto table = [&](const std::string& body) {
    return "<div class=\"wide\"><table class=\"numbers tolerances\">" + head + "<tbody>\n" + body +
           "</tbody></table></div>\n";
  };
  std::string html = table(groups);
  if (!solvers.empty())
    html += "<details><summary>Each solver</summary>" + table(solvers) + "</details>\n";
  return html;
}

}  // namespace odeum::report
