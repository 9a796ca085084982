// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/event_course.hpp"

#include <algorithm>
#include <map>

namespace odeum::formula {
namespace {

std::vector<Id> functions_of(const std::vector<Watched>& all) {
  std::vector<Id> ids;
  for (const Watched& watched : all) ids.push_back(watched.function);
  return ids;
}
std::vector<Id> values_of(const Event& event) {
  std::vector<Id> all;
  for (const auto& [state, value] : event.set) all.push_back(value);
  return all;
}
std::vector<Id> one(Id id) { return id == no_node ? std::vector<Id>{} : std::vector{id}; }

template <class Real>
class ConditionSteps {
 public:
  ConditionSteps(const Problem& problem, std::vector<typename EventRules<Real>::Step>& steps)
      : problem_(problem), steps_(steps) {}

  std::size_t add(Id id) {
    if (const auto known = place_.find(id); known != place_.end()) return known->second;
    const Node& node = problem_.graph[id];
    typename EventRules<Real>::Step step{node.op, {}, no_event, static_cast<Real>(node.value)};
    if (const auto found = problem_.comparisons.find(id); found != problem_.comparisons.end())
      step.function = found->second;
    else
      for (std::size_t k = 0; k < arity(node.op); ++k) step.of[k] = add(node.of[k]);
    steps_.push_back(step);
    return place_[id] = steps_.size() - 1;
  }

 private:
  const Problem& problem_;
  std::vector<typename EventRules<Real>::Step>& steps_;
  std::map<Id, std::size_t> place_;
};

}  // namespace

template <class Real>
bool EventRules<Real>::Condition::is_true(const std::vector<int>& signs) const {
  std::vector<Real> values(steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Step& step = steps[k];
    if (step.function != no_event) {
      const int sign = signs[step.function];
      values[k] = step.op == Op::less         ? sign > 0
                  : step.op == Op::less_equal ? sign >= 0
                                              : sign == 0;
    } else if (step.op == Op::constant) {
      values[k] = step.value;
    } else {
      values[k] = apply(step.op, values[step.of[0]], values[step.of[1]], values[step.of[2]]);
    }
  }
  return values.back() != 0;
}

template <class Real>
EventRules<Real>::EventRules(const Problem& problem, const std::function<Real(Real)>& constant)
    : states(problem.states),
      events(problem.events),
      watched(problem.watched),
      clocked(problem.clocked),
      functions(problem.graph, functions_of(problem.watched)),
      clocks(problem.graph, functions_of(problem.clocked)) {
  if (constant) functions.perturb(constant);
  for (std::size_t k = 0; k < events.size(); ++k) {
    const Event& event = events[k];
    Doing each{{problem.graph, values_of(event)},
               {problem.graph, one(event.delay)},
               {problem.graph, one(event.priority)},
               {}};
    if (event.condition != no_node)
      ConditionSteps<Real>(problem, each.condition.steps).add(event.condition);
    if (constant)
      for (Evaluator<Real>* const evaluator : {&each.values, &each.delay, &each.priority})
        evaluator->perturb(constant);
    doing.push_back(std::move(each));
    for (const long double t : event.times) timed.push_back({static_cast<Real>(t), k, no_event, 0});
  }
  for (std::size_t k = 0; k < clocked.size(); ++k)
    for (std::size_t zero = 0; zero < clocked[k].zeros.size(); ++zero) {
      const int before = clocked[k].sides[zero], after = clocked[k].sides[zero + 1];
      const bool crosses = clocked[k].sense == 0 || (after == clocked[k].sense && before != after);
      const auto t = static_cast<Real>(clocked[k].zeros[zero]);
      if (clocked[k].event == no_event)
        timed.push_back({t, no_event, watched.size() + k, after});
      else if (crosses)
        timed.push_back({t, clocked[k].event, no_event, 0});
    }
  std::ranges::stable_sort(timed, {}, &Timed::t);
}

template struct EventRules<double>;
template struct EventRules<long double>;

}  // namespace odeum::formula
