// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_switches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>

#include "odeum/formula/switch_times.hpp"

namespace odeum::cases {

std::vector<Switch> switches_of(const formula::Problem& problem, double end) {
  // Conditions are computed in double, and flip within a few roundings of the time.
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  std::vector<Switch> switches;
  // One at the end is one of the run too.
  const double beyond = end + roundings * std::abs(end);
  for (const long double time : formula::switch_times(problem, beyond).times) {
    const auto t = static_cast<double>(time);
    const double apart = std::max(roundings * std::abs(t), std::numeric_limits<double>::min());
    if (!switches.empty() && t - apart <= switches.back().after)
      switches.back().after = t + apart;
    else
      switches.push_back({t, t - apart, t + apart});
  }
  return switches;
}

std::function<std::vector<Switch>(double from, double to)> switches_of(
    const formula::Problem& problem) {
  if (!formula::has_timed_switches(problem)) return {};
  struct Known {
    formula::Problem problem;
    std::mutex mutex;
    std::map<double, std::vector<Switch>> by_end;
  };
  const auto known = std::make_shared<Known>();
  known->problem = problem;
  return [known](double from, double to) {
    const std::lock_guard lock(known->mutex);
    auto at = known->by_end.find(to);
    if (at == known->by_end.end())
      at = known->by_end.emplace(to, switches_of(known->problem, to)).first;
    return from_time(at->second, from);
  };
}

Entrants::Finish bound_by_sliding(double slides_from) {
  return [slides_from](Entrant& entrant) {
    entrant.solve = [slides_from, solve = std::move(entrant.solve)](const Request& request) {
      constexpr std::uint64_t most = 5'000'000;
      if (request.mode == Mode::fixed || !(request.stops.back() > slides_from) ||
          request.budget.evaluations <= most)
        return solve(request);
      Request bounded = request;
      bounded.budget.evaluations = most;
      bounded.budget.seconds = std::min(bounded.budget.seconds, 2.0);
      Outcome outcome = solve(bounded);
      if (outcome.status == Status::over_budget)
        outcome.detail += fmt::format(
            "; the solution stays where a condition changes (sliding), from t = {:.9g} on, and "
            "steps "
            "cross it again and again",
            slides_from);
      return outcome;
    };
  };
}

std::vector<Switch> from_time(std::vector<Switch> switches, double from) {
  std::erase_if(switches, [&](const Switch& at) { return at.t < from; });
  return switches;
}

}  // namespace odeum::cases
