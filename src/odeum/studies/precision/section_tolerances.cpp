// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "odeum/report/solver_groups.hpp"
#include "odeum/studies/precision/section.hpp"

namespace odeum::study {
namespace {

using report::Cell;
/// log10 of achieved over requested, and how many of the answers are wrong.
struct Missed {
  std::vector<double> decades;
  std::size_t wrong = 0;

  void add(const Missed& other) {
    decades.insert(decades.end(), other.decades.begin(), other.decades.end());
    wrong += other.wrong;
  }
};
/// By what was requested.
using Misses = std::map<double, Missed>;
using Tolerances = std::set<double, std::greater<>>;

// A colour for each factor of ten that an error is off; both ends are open.
std::string colour_of(double decades) {
  const int level = static_cast<int>(std::clamp(std::floor(decades + 0.5), -3.0, 3.0));
  return level < 0 ? fmt::format("t-{}", -level) : fmt::format("t{}", level);
}

Cell cell_of(Missed missed) {
  std::vector<double>& decades = missed.decades;
  if (decades.empty()) return {.text = "·", .style = "zero"};
  std::sort(decades.begin(), decades.end());
  const double median = decades[decades.size() / 2];
  const double shown = std::abs(median) < 0.05 ? 0 : median;  // no "-0.0"
  std::string title =
      decades.size() == 1
          ? fmt::format("achieved / requested = {:.2g}", std::pow(10, median))
          : fmt::format("achieved / requested: median {:.2g} of {} solvers, from {:.2g} to {:.2g}",
                        std::pow(10, median), decades.size(), std::pow(10, decades.front()),
                        std::pow(10, decades.back()));
  if (missed.wrong > 0) title += fmt::format("; {} wrong", missed.wrong);
  return {.text = fmt::format("{:+.1f}{}", shown, missed.wrong > 0 ? "✗" : ""),
          .style = colour_of(median),
          .title = title};
}

}  // namespace

std::string tolerance_table(const report::Facts& facts, const std::vector<PrecisionRow>& rows,
                            bool each_solver) {
  Tolerances tolerances;
  std::map<std::string, Misses> by_solver;
  for (const PrecisionRow& row : rows) {
    if (row.mode != Mode::adaptive || row.status != to_string(Status::ok)) continue;
    if (!(row.error > 0 && row.setting > 0)) continue;
    tolerances.insert(row.setting);
    by_solver[row.library + "/" + row.solver][row.setting].add(
        {{std::log10(row.error / row.setting)}, row.judged.answer == judge::Answer::wrong});
  }
  report::Table groups("numbers tolerances");
  std::vector<Cell> head{{"requested"}};
  for (const double tolerance : tolerances) head.push_back({fmt::format("{:.0e}", tolerance)});
  groups.head(head);
  report::Table solvers = groups;
  const auto add_row = [&](report::Table& table, const std::string& name, Misses misses) {
    std::vector<Cell> cells;
    for (const double tolerance : tolerances) cells.push_back(cell_of(misses[tolerance]));
    table.row({name}, cells);
  };
  for (const report::SolverGroup& group : report::make_groups(facts.solvers)) {
    Misses all;
    for (const SolverInfo* solver : group.solvers) {
      const auto found = by_solver.find(solver->id());
      if (found == by_solver.end()) continue;
      for (const auto& [tolerance, missed] : found->second) all[tolerance].add(missed);
      if (each_solver) add_row(solvers, solver->id(), found->second);
    }
    if (!all.empty()) add_row(groups, group.own ? "odeum: " + group.title : group.title, all);
  }
  return groups.html() + report::details("Each solver", solvers.html());
}

}  // namespace odeum::study
