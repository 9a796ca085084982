// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/event_course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace odeum::formula {
namespace {

constexpr int unknown_side = 2;

template <class Real>
int sign_of(Real value) {
  return static_cast<int>(value > 0) - static_cast<int>(value < 0);
}

/// The value of an expression that may be missing.
template <class Real>
Real value_or_zero(Id id, const Evaluator<Real>& evaluator, Real t, const std::vector<Real>& y) {
  Real value = 0;
  if (id != no_node) evaluator(t, y.data(), &value);
  return value;
}

}  // namespace

template <class Real>
Real EventCourse<Real>::rounding(Real t) {
  return 32 * std::numeric_limits<double>::epsilon() * std::abs(t);
}

template <class Real>
void EventCourse<Real>::begin(Real t, const State& y) {
  begun_ = true;
  const std::size_t seen = rules_->watched.size();
  State values(seen);
  rules_->functions(t, y.data(), values.data());
  for (const Real value : values) signs_.push_back(sign_of(value));
  for (const Watched& watched : rules_->clocked) {
    std::size_t past = 0;
    while (past < watched.zeros.size() && watched.zeros[past] <= t + rounding(t)) ++past;
    signs_.push_back(watched.sides[past]);
  }
  later_.assign(signs_.size(), unknown_side);
  // One that is zero at the start has its sign from then on.
  State clocks(rules_->clocked.size());
  rules_->clocks(t, y.data(), clocks.data());
  for (std::size_t k = 0; k < clocks.size() && !resumed_; ++k)
    if (clocks[k] == 0) later_[seen + k] = std::exchange(signs_[seen + k], 0);
  while (clock_ < rules_->timed.size() &&
         rules_->timed[clock_].t < t + (resumed_ ? 1 : -1) * rounding(t))
    ++clock_;
  for (const Event& event : rules_->events) {
    const auto k = static_cast<std::size_t>(&event - rules_->events.data());
    holds_.push_back(event.condition != no_node && (event.initially || resumed_) &&
                     rules_->doing[k].condition.is_true(signs_));
  }
}

template <class Real>
void EventCourse<Real>::take_clock(Real t, std::vector<std::size_t>& called) {
  for (; clock_ < rules_->timed.size() && rules_->timed[clock_].t <= t + rounding(t); ++clock_) {
    const auto& timed = rules_->timed[clock_];
    if (timed.event != no_event) {
      called.push_back(timed.event);
    } else {
      signs_[timed.function] = 0;
      later_[timed.function] = timed.side;
    }
  }
}

template <class Real>
std::string EventCourse<Real>::happen(Real t, const std::vector<Crossing>& crossings, State& y,
                                      const Ahead& ahead) {
  constexpr int most_rounds = 10'000;
  done_.clear();
  if (!begun_) begin(t, y);
  std::vector<std::size_t> called;
  for (const auto& [function, side] : crossings) {
    if (rules_->watched[function].event != no_event) {
      called.push_back(rules_->watched[function].event);
    } else {
      later_[function] = side == 0 ? signs_[function] : side;
      signs_[function] = 0;
    }
  }
  take_clock(t, called);
  for (const std::size_t event : called) call(event, t, y);
  look_at_conditions(t, y);
  bool looked = false;
  for (int round = 0; fault_.empty() && !stopped_; ++round) {
    if (round > most_rounds)
      return fmt::format("events call one another without end at t = {:.9g}",
                         static_cast<double>(t));
    if (carry_out(t, y)) {
      looked = false;
    } else {
      if (looked || !leave_zero(t, y, ahead)) break;
      looked = true;
    }
    look_at_conditions(t, y);
  }
  return fault_;
}

template <class Real>
void EventCourse<Real>::call(std::size_t event, Real t, const State& y) {
  const Event& what = rules_->events[event];
  const auto& doing = rules_->doing[event];
  const Real delay = value_or_zero(what.delay, doing.delay, t, y);
  if (!std::isfinite(delay) || delay < 0)
    fault_ = fmt::format("event {} at t = {:.9g} has the delay {}, which is not a time from 0 on",
                         what.name, static_cast<double>(t), static_cast<double>(delay));
  Pending pending{event, t + delay, {}};
  if (what.early) {
    pending.values.resize(what.set.size());
    doing.values(t, y.data(), pending.values.data());
  }
  pending_.push_back(std::move(pending));
}

template <class Real>
void EventCourse<Real>::look_at_conditions(Real t, const State& y) {
  for (std::size_t k = 0; k < holds_.size(); ++k) {
    const Event& event = rules_->events[k];
    if (event.condition == no_node) continue;
    const bool now = rules_->doing[k].condition.is_true(signs_), before = holds_[k];
    holds_[k] = now;
    if (now && !before) call(k, t, y);
    if (!now && before && !event.persistent)
      std::erase_if(pending_, [k](const Pending& pending) { return pending.event == k; });
  }
}

template <class Real>
std::vector<std::size_t> EventCourse<Real>::first_due(Real t, const State& y) const {
  std::vector<std::size_t> group;
  std::pair<Real, int> first;
  for (std::size_t k = 0; k < pending_.size(); ++k) {
    if (pending_[k].due > t + rounding(t)) continue;
    const std::size_t event = pending_[k].event;
    const Event& what = rules_->events[event];
    const std::pair key{-value_or_zero(what.priority, rules_->doing[event].priority, t, y),
                        what.order};
    if (!group.empty() && first < key) continue;
    const auto is_again = [&](std::size_t other) { return pending_[other].event == event; };
    if (!group.empty() && key == first && std::ranges::any_of(group, is_again)) continue;
    if (group.empty() || key < first) group.clear();
    first = key;
    group.push_back(k);
  }
  return group;
}

template <class Real>
bool EventCourse<Real>::carry_out(Real t, State& y) {
  const std::vector<std::size_t> group = first_due(t, y);
  if (group.empty()) return false;
  const State before = y;
  const std::size_t seen = rules_->watched.size();
  State old_values(seen), new_values(seen);
  rules_->functions(t, y.data(), old_values.data());
  if (!set(group, t, y)) return false;
  for (const std::size_t k : group) {
    done_.push_back({pending_[k].event, before, y});
    stopped_ = stopped_ || rules_->events[pending_[k].event].stop;
  }
  for (std::size_t k = group.size(); k-- > 0;)
    pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(group[k]));
  rules_->functions(t, y.data(), new_values.data());
  for (std::size_t k = 0; k < seen; ++k)
    if (!(new_values[k] == old_values[k])) {
      signs_[k] = sign_of(new_values[k]);
      later_[k] = unknown_side;
    }
  return true;
}

template <class Real>
bool EventCourse<Real>::set(const std::vector<std::size_t>& group, Real t, State& y) {
  std::map<std::size_t, std::pair<std::size_t, Real>> after;
  for (const std::size_t k : group) {
    const Event& event = rules_->events[pending_[k].event];
    State values = pending_[k].values;
    values.resize(event.set.size());
    if (!event.early) rules_->doing[pending_[k].event].values(t, y.data(), values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string& name = rules_->states[event.set[i].first];
      if (!std::isfinite(values[i])) {
        fault_ = fmt::format("event {} at t = {:.9g} sets {} to a value that is not finite",
                             event.name, static_cast<double>(t), name);
        return false;
      }
      const auto [at, added] = after.try_emplace(event.set[i].first, pending_[k].event, values[i]);
      if (added) continue;
      fault_ = fmt::format(
          "events {} and {} both set {} at t = {:.9g}, and no `order` says which comes first",
          rules_->events[at->second.first].name, event.name, name, static_cast<double>(t));
      return false;
    }
  }
  for (const auto& [state, value] : after) y[state] = value.second;
  return true;
}

/// A function that is zero at t has a sign again a little later. Whether one has got it.
template <class Real>
bool EventCourse<Real>::leave_zero(Real t, const State& y, const Ahead& ahead) {
  std::vector<int> next;
  bool has_left = false, has_looked = false;
  for (std::size_t k = 0; k < signs_.size(); ++k) {
    if (signs_[k] != 0) continue;
    const bool is_watched = k < rules_->watched.size();
    if (is_watched && rules_->watched[k].event != no_event) continue;
    if (later_[k] == unknown_side && is_watched && !std::exchange(has_looked, true))
      next = ahead(t, y);
    if (later_[k] != unknown_side)
      signs_[k] = later_[k];
    else if (k < next.size())
      signs_[k] = next[k];
    has_left = has_left || signs_[k] != 0;
  }
  return has_left;
}

template <class Real>
Real EventCourse<Real>::next() const {
  Real t = clock_ < rules_->timed.size() ? rules_->timed[clock_].t
                                         : std::numeric_limits<Real>::infinity();
  for (const Pending& pending : pending_) t = std::min(t, pending.due);
  return t;
}

template class EventCourse<double>;
template class EventCourse<long double>;

}  // namespace odeum::formula
