// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/text_happenings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace odeum::truth {

/// Numbers of few binary digits are exact.
Real moved(Real c) {
  constexpr Real few = 0x1p24L;
  const bool exact = c == 0 || std::ldexp(few, std::ilogb(c)) == 0 ||
                     std::remainder(c, std::ldexp(1 / few, std::ilogb(c))) == 0;
  return exact ? c : c * (1 + moved_by);
}

void add_happenings(const formula::Problem& problem, System& system) {
  if (problem.events.empty()) return;
  using Rules = formula::EventRules<Real>;
  auto all = std::make_shared<Happenings>();
  std::map<Real, std::vector<std::size_t>> by_time;
  std::vector<bool> stops;
  for (std::size_t k = 0; k < problem.events.size(); ++k) {
    stops.push_back(problem.events[k].stop);
    for (const Real t : problem.events[k].times) {
      // Times that double does not tell apart are one.
      const Real rounding = 4 * std::numeric_limits<double>::epsilon() * std::abs(t);
      const auto near = by_time.lower_bound(t - rounding);
      by_time[near != by_time.end() && near->first <= t + rounding ? near->first : t].push_back(k);
    }
  }
  std::vector<std::vector<std::size_t>> timed;
  for (const auto& [t, events] : by_time) {
    all->times.push_back(t);
    timed.push_back(events);
  }
  const std::vector<std::size_t> crossed = formula::crossed_events(problem);
  for (const std::size_t k : crossed) all->senses.push_back(problem.events[k].sense);
  const auto rules = std::make_shared<const Rules>(problem),
             moved_rules = std::make_shared<const Rules>(problem, moved);
  all->values = [rules, moved_rules](Real t, const Real* y, Real* values, bool is_moved) {
    (is_moved ? moved_rules : rules)->functions(t, y, values);
  };
  all->apply = [=](Real t, const std::vector<std::size_t>& functions, std::size_t time, State& y,
                   bool is_moved, bool& ends) {
    std::vector<std::size_t> events;
    for (const std::size_t k : functions) events.push_back(crossed[k]);
    if (time < timed.size()) events.insert(events.end(), timed[time].begin(), timed[time].end());
    ends = std::ranges::any_of(events, [&](std::size_t k) { return stops[k]; });
    return (is_moved ? moved_rules : rules)->apply(t, events, y.data());
  };
  system.switches.insert(system.switches.end(), all->times.begin(), all->times.end());
  std::ranges::sort(system.switches);
  system.events = std::move(all);
}

}  // namespace odeum::truth
