// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "goals.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/solvers/inlined.hpp"

namespace odeum::bench {
namespace {

const Entrant* find(const std::vector<Entrant>& entrants, const std::string& id) {
  const auto found = std::find_if(entrants.begin(), entrants.end(),
                                  [&](const Entrant& e) { return e.info.id() == id; });
  return found == entrants.end() ? nullptr : &*found;
}

}  // namespace

// All with an inlined right-hand side and no guard.
std::vector<Row> fixed_step_rows() {
  std::vector<Row> rows;
  for (const char* id : {"osc_undamped", "kepler_e06", "hires", "pleiades"}) {
    const Case& c = known_case(id);
    const std::vector<Entrant> inlined = inlined_solvers(c);
    Request request;
    request.mode = Mode::fixed;
    request.stops = c.stops;
    request.budget.watched = false;
    // A step at which every method is stable, as many as take some milliseconds.
    request.steps = (id == std::string("hires") ? 200'000 : 40'000) / c.settings.steps_multiple *
                    c.settings.steps_multiple;
    std::vector<std::function<void()>> rivals;
    std::vector<std::string> names;
    for (const char* solver : {"odeum/rk4", "odeint/runge_kutta4", "odeint/runge_kutta4_classic"})
      if (const Entrant* entrant = find(inlined, solver)) {
        names.emplace_back(solver);
        rivals.emplace_back([entrant, &request] { entrant->solve(request); });
      }
    if (rivals.size() < 2 || names[0] != "odeum/rk4") continue;
    const std::vector<Timing> t = interleave(rivals, 2);
    const auto best = std::min_element(
        t.begin() + 1, t.end(), [](const Timing& a, const Timing& b) { return a.min < b.min; });
    Row row = compare(
        fmt::format("{}: own RK4 / odeint's, time a step", id), 1.05, *best, t[0],
        fmt::format("{:.1f} ns a step; {}", 1e9 * t[0].min / static_cast<double>(request.steps),
                    names[static_cast<std::size_t>(best - t.begin())]));
    row.at_most = true;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace odeum::bench
