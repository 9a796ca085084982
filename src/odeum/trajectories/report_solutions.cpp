// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "odeum/cases/catalogue.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/trajectories/solutions.hpp"

namespace odeum::trajectories {
namespace {

/// What a run may cost: of large problems, whose evaluations are long, less.
std::uint64_t budget_of(const Case& c) {
  return c.y0.size() > dense_dimension_limit ? 1'500 : 10'000;
}

nlohmann::ordered_json drawn(const Case& c, double end, std::vector<CaseRun> runs, unsigned jobs) {
  parallel_for(runs.size(), jobs,
               [&](std::size_t i) { runs[i].outcome = runs[i].entrant->solve(runs[i].request); });
  std::set<double> times;
  for (const CaseRun& run : runs) times.insert(run.request.stops.begin(), run.request.stops.end());
  Solutions solutions(c, end, exact_curve(c, {times.begin(), times.end()}));
  for (const CaseRun& run : runs) solutions.add(run);
  return solutions.json();
}

/// The runs to draw, by where they end: timed runs may be longer. Of a run that failed, what came
/// before is drawn.
std::map<double, std::vector<CaseRun>> chosen_of(const Case& c,
                                                 const study::ConvergenceResult& converged,
                                                 const study::PrecisionResult& timed) {
  std::map<std::string, const Entrant*> entrants;
  for (const Entrant& entrant : c.entrants)
    if (entrant.unfit.empty()) entrants[entrant.info.id()] = &entrant;
  std::map<double, std::vector<CaseRun>> by_end;
  std::set<std::tuple<const Entrant*, double, Mode, double>> known;  // end, steps or 1 / tolerance
  const auto add = [&](const measure::RunRecord& row, double end) {
    if (row.case_id != c.id || std::isnan(row.setting) || row.status == "not_applicable" ||
        row.status == to_string(Status::over_budget) || row.status == to_string(Status::refused) ||
        row.counters.rhs_evaluations > budget_of(c))
      return;
    const auto found = entrants.find(row.library + "/" + row.solver);
    if (found == entrants.end()) return;
    const Request request = drawn_request(c, row.mode, row.setting, end,
                                          {.evaluations = 4 * budget_of(c), .seconds = 2});
    if (known.emplace(found->second, end, row.mode, fineness_of(request)).second)
      by_end[end].push_back({found->second, request, {}});
  };
  for (const study::ConvergenceRow& row : converged.rows) add(row, c.stops.back());
  for (const study::PrecisionRow& row : timed.rows) add(row, c.timed_stops().back());
  return by_end;
}

}  // namespace

void add_solutions(report::Report& report, const std::vector<std::string>& cases,
                   const study::ConvergenceResult& converged, const study::PrecisionResult& timed,
                   unsigned jobs) {
  Progress progress("solutions", static_cast<double>(report.facts().cases.size()));
  nlohmann::ordered_json kept = nlohmann::ordered_json::object();
  for (const report::CaseFacts& facts : report.facts().cases) {
    progress.advance();
    if (!cases.empty() && std::ranges::find(cases, facts.id) == cases.end()) continue;
    const Case& c = known_case(facts.id);
    nlohmann::ordered_json sets = nlohmann::ordered_json::array();
    for (const auto& [end, chosen] : chosen_of(c, converged, timed))
      sets.push_back(drawn(c, end, chosen, jobs));
    if (sets.empty()) continue;
    const std::string name = fmt::format("solutions-{}", kept.size());
    report.data(name, nlohmann::ordered_json{{"sets", sets}}.dump());
    kept[facts.id] = name;
  }
  report.fact("solutions", kept);
}

}  // namespace odeum::trajectories
