// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "odeum/proof/facts.hpp"
#include "odeum/proof/structure_check.hpp"
#include "odeum/report/chart.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/solver_tables.hpp"
#include "odeum/studies/drift/section.hpp"

namespace odeum::study {
namespace {

// Below it nothing but rounding is seen, above it the solution is lost.
constexpr double lowest = 1e-17, highest = 1e2;

/// The kinds of line, those drawn first lying below.
enum Kind : std::size_t { peer, own, symplectic };
const report::Key keys[] = {{.text = "other peers", .line = "run peer"},
                            {.text = "other own methods", .line = "run own"},
                            {.text = "symplectic", .line = "run kept"}};

Kind kind_of(const SolverInfo& solver) {
  static const std::set<std::string> keep_the_form = [] {
    std::set<std::string> ids;
    for (const proof::MethodFacts& method : proof::all_method_facts())
      if (const auto mechanics = method.on_mechanics();
          mechanics &&
          proof::symplectic_defect(mechanics, proof::structure_step) <= proof::symplectic_rounding)
        ids.insert("odeum/" + method.id());
    return ids;
  }();
  if (solver.family == "symplectic" || keep_the_form.contains(solver.id())) return symplectic;
  return solver.library == "odeum" ? own : peer;
}

std::vector<report::ChartPoint> points_of(const std::vector<const DriftRow*>& series) {
  std::vector<report::ChartPoint> points;
  for (const DriftRow* row : series) {
    if (!(row->relative_error > lowest) || !(row->time > 0)) continue;
    points.emplace_back(row->time, std::min(row->relative_error, highest));
    if (row->relative_error >= highest) break;  // what follows is off the chart as well
  }
  return points;
}

}  // namespace

std::string drift_diagram(const report::Facts& facts, const std::vector<DriftRow>& rows,
                          const std::string& case_id) {
  const auto series = report::by_solver(rows, [&](const DriftRow& row) {
    return row.case_id == case_id && row.invariant == "energy" && !std::isnan(row.relative_error);
  });
  std::map<Kind, std::vector<const SolverInfo*>> solvers;
  report::Axis time, error;
  for (const SolverInfo& solver : facts.solvers) {
    const auto found = series.find(solver.id());
    if (found == series.end()) continue;
    solvers[kind_of(solver)].push_back(&solver);
    for (const auto& [t, e] : points_of(found->second)) time.include(t), error.include(e);
  }
  if (time.empty() || error.empty()) return {};
  report::Chart chart(report::large_chart, time.widened(1.2), error.widened(2),
                      {.x = "time",
                       .y = "relative error of the energy",
                       .description = "relative error of the energy against time"});
  std::vector<report::Key> used;
  for (const auto& [kind, members] : solvers) {
    used.push_back(keys[kind]);
    for (const SolverInfo* solver : members)
      chart.line(points_of(series.at(solver->id())), keys[kind].line, solver->id());
  }
  return fmt::format("<figure><figcaption><code>{}</code>: energy</figcaption>{}{}</figure>\n",
                     report::escape(case_id), chart.svg(), report::legend(used));
}

}  // namespace odeum::study
