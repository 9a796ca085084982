// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/event.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "odeum/formula/problem.hpp"

namespace odeum::formula {
namespace {

std::vector<Id> expressions_of(const Problem& problem) {
  std::vector<Id> all;
  for (const std::size_t k : crossed_events(problem)) all.push_back(problem.events[k].when);
  return all;
}
std::vector<Id> values_of(const Event& event) {
  std::vector<Id> all;
  for (const auto& [state, value] : event.set) all.push_back(value);
  return all;
}

}  // namespace

std::vector<std::size_t> crossed_events(const Problem& problem) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < problem.events.size(); ++k)
    if (problem.events[k].when != no_node) all.push_back(k);
  return all;
}

template <class Real>
struct EventRules<Real>::Compiled {
  Compiled(const Problem& problem, const std::function<Real(Real)>& constant)
      : states(problem.states),
        events(problem.events),
        expressions(problem.graph, expressions_of(problem)) {
    for (const Event& event : events) values.emplace_back(problem.graph, values_of(event));
    if (!constant) return;
    expressions.perturb(constant);
    for (Evaluator<Real>& value : values) value.perturb(constant);
  }
  std::vector<std::string> states;
  std::vector<Event> events;
  Evaluator<Real> expressions;
  std::vector<Evaluator<Real>> values;
};

template <class Real>
EventRules<Real>::EventRules(const Problem& problem, const std::function<Real(Real)>& constant)
    : compiled_(new Compiled(problem, constant)) {}
template <class Real>
EventRules<Real>::~EventRules() {
  delete compiled_;
}

template <class Real>
void EventRules<Real>::functions(Real t, const Real* y, Real* values) const {
  compiled_->expressions(t, y, values);
}

template <class Real>
std::string EventRules<Real>::apply(Real t, const std::vector<std::size_t>& events, Real* y) const {
  std::map<int, std::vector<std::size_t>> by_order;
  for (const std::size_t k : events) by_order[compiled_->events[k].order].push_back(k);
  for (const auto& [order, at_once] : by_order) {
    std::map<std::size_t, std::pair<std::size_t, Real>> after;
    for (const std::size_t k : at_once) {
      const Event& event = compiled_->events[k];
      std::vector<Real> values(event.set.size());
      compiled_->values[k](t, y, values.data());
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string& name = compiled_->states[event.set[i].first];
        if (!std::isfinite(values[i]))
          return fmt::format("event {} at t = {:.9g} sets {} to a value that is not finite",
                             event.name, static_cast<double>(t), name);
        const auto [at, added] = after.try_emplace(event.set[i].first, k, values[i]);
        if (!added)
          return fmt::format(
              "events {} and {} both set {} at t = {:.9g}, and no `order` says which comes first",
              compiled_->events[at->second.first].name, event.name, name, static_cast<double>(t));
      }
    }
    for (const auto& [state, value] : after) y[state] = value.second;
  }
  return {};
}

template class EventRules<double>;
template class EventRules<long double>;

}  // namespace odeum::formula
