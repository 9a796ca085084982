// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "odeum/record/table.hpp"
#include "odeum/report/chart.hpp"
#include "odeum/report/page.hpp"
#include "odeum/report/table.hpp"
#include "odeum/studies/evolution/rows.hpp"

namespace odeum::study {
namespace {

record::Table orders_table(const EvolutionResult& result) {
  return record::table_of(result.orders, {{"problem", "{problem}"},
                                          {"solver", "{solver}"},
                                          {"in", "{direction}"},
                                          {"claimed", "{claimed_order:.0f}"},
                                          {"measured", "{measured_order:.2f}"},
                                          {"verdict", "{verdict}: {reason}"}});
}
record::Table cheapest_table(const EvolutionResult& result) {
  return record::table_of(result.cheapest, {{"problem", "{problem}"},
                                            {"error", "{target:.0e}"},
                                            {"solver", "{solver}"},
                                            {"divisions", "{divisions:d}"},
                                            {"steps", "{steps:d}"},
                                            {"h", "{h:.3g}"},
                                            {"dt", "{dt:.3g}"},
                                            {"reached", "{error:.1e}"},
                                            {"multiplications", "{work:.2g}"},
                                            {"status", "{status}"}});
}
record::Table modes_table(const EvolutionResult& result) {
  return record::table_of(result.modes, {{"problem", "{problem}"},
                                         {"mass", "{mass}"},
                                         {"solver", "{solver}"},
                                         {"of", "{quantity}"},
                                         {"half waves", "{waves:d}"},
                                         {"eigenvalue or frequency x dt", "{step:.3g}"},
                                         {"measured", "{observed:.4g}"},
                                         {"predicted", "{predicted:.4g}"}});
}
record::Table limits_table(const EvolutionResult& result) {
  return record::table_of(result.limits, {{"problem", "{problem}"},
                                          {"mass", "{mass}"},
                                          {"solver", "{solver}"},
                                          {"predicted", "{predicted:.5g}"},
                                          {"measured", "{observed:.5g}"}});
}

/// Errors of one solver by mesh (a row each) and number of steps.
record::Table grid_of(const std::vector<EvolutionRow>& runs, const std::string& problem,
                      const std::string& solver) {
  std::map<std::size_t, std::map<std::size_t, double>> errors;
  std::set<std::size_t> steps;
  for (const EvolutionRow& row : runs)
    if (row.problem == problem && row.solver == solver) {
      errors[row.divisions][row.steps] = row.error;
      steps.insert(row.steps);
    }
  record::Table table;
  if (errors.empty()) return table;
  table.columns.push_back({"divisions", true});
  for (const std::size_t count : steps)
    table.columns.push_back({fmt::format("{} steps", count), true});
  for (const auto& [divisions, by_steps] : errors) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row.push_back(std::to_string(divisions));
    for (const std::size_t count : steps) {
      const auto found = by_steps.find(count);
      row.push_back(found == by_steps.end() ? "" : fmt::format("{:.1e}", found->second));
    }
  }
  return table;
}

/// The least error for the work, a curve for each solver.
std::string work_chart(const std::vector<EvolutionRow>& runs, const std::string& problem) {
  report::Curves curves;
  for (const EvolutionRow& row : runs)
    if (row.problem == problem && row.status == "ok" && row.error > 0)
      curves[row.solver].emplace_back(row.work, row.error);
  for (auto& [solver, points] : curves) {
    std::sort(points.begin(), points.end());
    double least = 1;  // an error as large as the solution says nothing
    std::erase_if(points, [&](const report::ChartPoint& p) {
      if (!(p.second < least)) return true;
      least = p.second;
      return false;
    });
  }
  return report::figure_of(curves,
                           {.x = "multiplications",
                            .y = "error",
                            .description = problem + ": error against work, at the best pairs"},
                           1.3);
}

/// For each error the solver, mesh and step of the least work.
std::string best_pairs(const EvolutionResult& result, const std::string& problem) {
  std::map<double, const EvolutionCheapestRow*, std::greater<>> best;
  for (const EvolutionCheapestRow& row : result.cheapest)
    if (row.problem == problem && row.status == "ok") {
      const EvolutionCheapestRow*& least = best[row.target];
      if (!least || row.work < least->work) least = &row;
    }
  std::string text;
  for (const auto& [target, row] : best)
    text += fmt::format("{}{:.0e}: h = 1/{}, dt = {:.2g} by {}", text.empty() ? "" : "; ", target,
                        row->divisions, row->dt, row->solver);
  return text;
}

std::string html_of(const EvolutionResult& result) {
  std::string html =
      "<p>M u' = −K u and M u'' = −K u by linear elements on right triangles of the unit square, "
      "whose exact solutions are known: the error of the elements and that of the steps are "
      "measured apart. Work is counted in multiplications: products with K, sparse factorisations, "
      "and solutions with their factors.</p>\n";
  for (const auto& [problem, solver] :
       {std::pair{"heat", "odeum/trapezoidal"}, {"wave", "odeum/velocity_verlet"}}) {
    html += work_chart(result.runs, problem);
    if (const std::string text = best_pairs(result, problem); !text.empty())
      html += fmt::format("<p>{}: the cheapest mesh and step for an error of {}.</p>\n",
                          problem == std::string("heat") ? "Heat" : "Wave", text);
    if (const record::Table grid = grid_of(result.runs, problem, solver); !grid.rows.empty())
      html += report::details(fmt::format("{}: errors of {} by mesh and steps", problem, solver),
                              report::html_of(grid));
  }
  html += report::details("Orders in time, on one mesh, and in space",
                          report::html_of(orders_table(result)));
  html += report::details("The cheapest pair of mesh and step for an error, by solver",
                          report::html_of(cheapest_table(result)));
  html +=
      "<p>Rough data: what eight steps leave of the fastest mode of a jump, 50 times longer than "
      "its time. The trapezoidal rule (Crank and Nicolson’s) is A-stable and keeps more than half "
      "of it; the L-stable solvers keep nothing. Waves: the speed at which a step moves a wave of "
      "so many half waves on a mesh of 16 divisions, against the equation’s: short waves are slow. "
      "Leapfrog makes up for a part of what the elements lose, Newmark’s average acceleration (the "
      "trapezoidal rule) adds to it.</p>\n" +
      report::details("Modes, measured and predicted", report::html_of(modes_table(result))) +
      "<p>A consistent mass matrix has higher eigenvalues: its explicit steps are shorter.</p>\n" +
      report::html_of(limits_table(result));
  return html;
}

std::string table(const EvolutionResult& result) {
  return orders_table(result).text() + "\n" + cheapest_table(result).text() + "\n" +
         modes_table(result).text() + "\n" + limits_table(result).text();
}

void add_section(report::Page& page, const EvolutionResult& result, const Origin& origin) {
  const bool none = result.orders.empty();
  page.section({.id = "evolution",
                .title = "Heat and waves",
                .place = origin.place,
                .html = origin_text(origin, none) + (none ? "" : html_of(result))});
}

}  // namespace

std::unique_ptr<Study> make_evolution() {
  return make_study<EvolutionResult>(
      {.name = "evolution",
       .help = "heat and waves by finite elements: errors of mesh and of steps apart, and "
               "the cheapest pair of both",
       .place = 79,
       .cases_help = "",
       .options = {{.name = "most",
                    .help = "divisions of the finest mesh, of which the largest power of "
                            "two is taken; default: 128",
                    .least = 16,
                    .most = 512,
                    .whole = true}}},
      {.measure = measure_evolution, .table = table, .section = add_section});
}

}  // namespace odeum::study
