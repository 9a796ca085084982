// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "odeum/cases/text_switches.hpp"

namespace odeum::cases {

std::shared_ptr<const Events> events_of(const formula::Problem& problem) {
  if (problem.events.empty()) return nullptr;
  auto all = std::make_shared<Events>();
  std::vector<std::pair<double, std::size_t>> at;
  for (std::size_t k = 0; k < problem.events.size(); ++k) {
    const formula::Event& event = problem.events[k];
    all->names.push_back(event.name);
    all->stops.push_back(event.stop);
    for (const long double t : event.times) at.emplace_back(static_cast<double>(t), k);
    if (event.when != formula::no_node) all->crossed.push_back({k, event.sense});
  }
  std::ranges::sort(at);
  for (const auto& [t, event] : at) {
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::abs(t);
    if (all->timed.empty() || t > all->timed.back().t + rounding) all->timed.push_back({t, {}});
    all->timed.back().events.push_back(event);
  }
  const auto rules = std::make_shared<const formula::EventRules<double>>(problem);
  all->functions = [rules](double t, const double* y, double* values) {
    rules->functions(t, y, values);
  };
  all->apply = [rules](double t, const std::vector<std::size_t>& events, double* y) {
    return rules->apply(t, events, y);
  };
  return all;
}

bool take_changes(const formula::Problem& problem, Case& c) {
  c.problem.switches = switches_of(problem);
  c.problem.events = events_of(problem);
  if (!c.problem.events) return static_cast<bool>(c.problem.switches);
  c.invariants.clear();
  c.energy = {};
  c.extended = nullptr;
  return true;
}

std::string events_in_words(const Events* events) {
  if (!events) return {};
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t k = 0; k < std::min(events->names.size(), most); ++k)
    text += fmt::format("{}{}{}", k == 0 ? "" : ", ", events->names[k],
                        events->stops[k] ? " (stops)" : "");
  if (events->names.size() > most) text += fmt::format(", ... ({})", events->names.size());
  return text + ": runs and the truth are continued from one to the next";
}

}  // namespace odeum::cases
