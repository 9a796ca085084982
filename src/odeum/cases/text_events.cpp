// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "odeum/cases/text_switches.hpp"
#include "odeum/formula/event_course.hpp"

namespace odeum::cases {

std::shared_ptr<const Events> events_of(const formula::Problem& problem) {
  if (problem.events.empty()) return nullptr;
  auto all = std::make_shared<Events>();
  for (const formula::Event& event : problem.events) {
    all->names.push_back(event.name);
    all->stops.push_back(event.stop);
    all->remembers = all->remembers || event.delay != formula::no_node;
  }
  for (const formula::Watched& watched : problem.watched) {
    all->senses.push_back(watched.sense);
    all->of_events += watched.event != formula::no_event ? 1 : 0;
  }
  all->known_until = static_cast<double>(problem.events_until);
  const auto rules = std::make_shared<const formula::EventRules<double>>(problem);
  all->functions = [rules](double t, const double* y, double* values) {
    rules->functions(t, y, values);
  };
  all->course = [rules](bool resumed) {
    return std::make_unique<formula::EventCourse<double>>(rules, resumed);
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
