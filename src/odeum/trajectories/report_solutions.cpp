// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/trajectories/solutions.hpp"

namespace odeum::trajectories {
namespace {

/// A run by solver, mode, steps or tolerance.
using Key = std::tuple<std::string, Mode, std::uint64_t, double>;

/// What a run may cost: of large problems, whose evaluations are long, less.
std::uint64_t budget_of(const Case& c) {
  return c.y0.size() > dense_dimension_limit ? 1'500 : 10'000;
}

class Chosen {
 public:
  explicit Chosen(const Case& c) : case_(c) {
    for (const Entrant& entrant : c.entrants) entrants_[entrant.info.id()] = &entrant;
  }
  void add(const std::string& id, const std::string& status, std::uint64_t evaluations,
           DrawnRun run) {
    const auto found = entrants_.find(id);
    if (found == entrants_.end() || !found->second->unfit.empty()) return;
    // Of a run that failed, what came before.
    if (status == "not_applicable" || status == to_string(Status::over_budget) ||
        status == to_string(Status::refused) || evaluations > budget_of(case_))
      return;
    run.entrant = found->second;
    if (known_.insert({id, run.mode, run.steps, run.tolerance}).second) runs.push_back(run);
  }
  std::vector<DrawnRun> runs;

 private:
  const Case& case_;
  std::map<std::string, const Entrant*> entrants_;
  std::set<Key> known_;
};

nlohmann::ordered_json drawn(const Case& c, double end, const std::vector<DrawnRun>& runs,
                             unsigned jobs) {
  std::vector<Request> requests;
  std::set<double> times;
  for (const DrawnRun& run : runs) {
    requests.push_back(drawn_request(c, run, 4 * budget_of(c)));
    times.insert(requests.back().stops.begin(), requests.back().stops.end());
  }
  std::vector<Outcome> outcomes(runs.size());
  parallel_for(runs.size(), jobs,
               [&](std::size_t i) { outcomes[i] = runs[i].entrant->solve(requests[i]); });
  Solutions solutions(c, end, exact_curve(c, {times.begin(), times.end()}));
  for (std::size_t i = 0; i < runs.size(); ++i) solutions.add(runs[i], requests[i], outcomes[i]);
  return solutions.json();
}

/// By where they end: timed runs may be longer.
std::map<double, Chosen> chosen_of(const Case& c, const study::ConvergenceResult& converged,
                                   const study::PrecisionResult& timed) {
  std::map<double, Chosen> by_end;
  const auto add = [&](const auto& row, double setting, double end) {
    if (row.case_id != c.id || std::isnan(setting)) return;
    DrawnRun run{.mode = row.mode, .end = end};
    if (run.mode == Mode::fixed)
      run.steps = static_cast<std::uint64_t>(std::llround((end - c.t0) / setting));
    else
      run.tolerance = setting;
    by_end.try_emplace(end, c).first->second.add(row.library + "/" + row.solver, row.status,
                                                 row.counters.rhs_evaluations, run);
  };
  for (const study::ConvergenceRow& row : converged.rows)
    add(row, row.mode == Mode::fixed ? row.step : row.tolerance, c.stops.back());
  for (const study::PrecisionRow& row : timed.rows) add(row, row.setting, c.timed_stops().back());
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
    const Case& c = study::find_case(facts.id);
    nlohmann::ordered_json sets = nlohmann::ordered_json::array();
    for (const auto& [end, chosen] : chosen_of(c, converged, timed))
      if (!chosen.runs.empty()) sets.push_back(drawn(c, end, chosen.runs, jobs));
    if (sets.empty()) continue;
    const std::string name = fmt::format("solutions-{}", kept.size());
    report.data(name, nlohmann::ordered_json{{"sets", sets}}.dump());
    kept[facts.id] = name;
  }
  report.fact("solutions", kept);
}

}  // namespace odeum::trajectories
