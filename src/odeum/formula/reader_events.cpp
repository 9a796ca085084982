// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "odeum/formula/evaluator.hpp"
#include "odeum/formula/reader.hpp"
#include "odeum/input/near_words.hpp"

namespace odeum::formula::reading {
namespace {

constexpr std::string_view keys[] = {"name",  "when",     "rising", "falling",    "at",
                                     "every", "until",    "set",    "stop",       "order",
                                     "delay", "priority", "early",  "persistent", "initially"};
constexpr std::size_t most_times = 100'000;

bool both_ways(const Event& a, const Event& b) {
  return a.sense == 0 || b.sense == 0 || a.sense == b.sense;
}

/// Whether two events happen at once wherever one of them does, or at one time at least.
bool meet(const Event& a, const Event& b) {
  // What conditions and delays have in common shows when they run.
  if (a.condition != no_node || b.condition != no_node || a.delay != b.delay) return false;
  if (a.when != no_node || b.when != no_node) return a.when == b.when && both_ways(a, b);
  for (const long double t : a.times) {
    const long double rounding = 4 * std::numeric_limits<double>::epsilon() * std::abs(t);
    const auto near = std::ranges::lower_bound(b.times, t - rounding);
    if (near != b.times.end() && *near <= t + rounding) return true;
  }
  return false;
}

/// A function without a value has no zero, and its event would be missed in silence.
bool is_finite_at_start(const Problem& problem, Id function) {
  long double value = 0;
  Evaluator<long double>(problem.graph, {function})(problem.t0, problem.y0.data(), &value);
  return std::isfinite(value);
}

}  // namespace

void Reader::read_events(const Scope& scope) {
  const Item* const list = section("events");
  if (!list) return;
  if (list->value->kind != YamlNode::Kind::sequence || list->value->items.empty())
    fail(list->value->place,
         "events: got {}, expected a list: `- {{when: x, falling: true, set: {{v: -v}}}}` or `- "
         "{{at: 1, every: 2, until: 9, set: {{x: x + 1}}}}`",
         list->value->kind_name());
  for (const char* key : {"residuals", "exact", "invariants"})
    if (const Item* const other = section(key))
      fail(other->key_place,
           "{}: got this beside events, across which it does not hold, expected "
           "one of the two",
           key);
  // A run may be asked to go beyond the end.
  problem_.events_until = problem_.t0 + 16 * (problem_.stops.back() - problem_.t0);
  for (const auto& item : list->value->items)
    problem_.events.push_back(read_event(*item, problem_.events.size() + 1, scope));
  require_order();
  watch_events(problem_);
  for (const std::vector<Watched>* const all : {&problem_.watched, &problem_.clocked})
    for (const Watched& watched : *all)
      if (!is_finite_at_start(problem_, watched.function))
        fail(list->value->place,
             "events: a comparison of {} is not finite at the start, expected numbers",
             watched.event == no_event ? "a condition" : problem_.events[watched.event].name);
  for (const Item& item : items("definitions"))
    problem_.events_text += fmt::format("{} = {}\n", item.key, scalar(*item.value, item.key));
  for (const auto& [name, value] : problem_.parameters)
    problem_.events_text += fmt::format("{} {:.21Lg}\n", name, value);
}

bool Reader::is_true(const std::vector<Item>& all, const std::string& path, std::string_view key,
                     bool usual) const {
  const Item* const item = input::entry_of(all, key);
  if (!item) return usual;
  const std::string text = scalar(*item->value, path + ": " + item->key);
  if (text != "true" && text != "false")
    fail(item->value->place, "{}: {}: got {}, expected true or false", path, key, shown(text));
  return text == "true";
}

Event Reader::read_event(const YamlNode& node, std::size_t place, const Scope& scope) {
  const std::string path = fmt::format("events[{}]", place);
  const std::vector<Item> all = items(node, path, keys);
  const auto find = [&](std::string_view key) { return input::entry_of(all, key); };
  Event event;
  event.place = node.place;
  const Item *const when = find("when"), *const at = find("at");
  if (!when == !at)
    fail(node.place, "{}: got {}, expected `when: expression` or `at: time`", path,
         when ? "both when and at" : "neither when nor at");
  const auto refuse = [&](std::initializer_list<const char*> names, const char* beside) {
    for (const char* key : names)
      if (const Item* const extra = find(key))
        fail(extra->key_place, "{}: {}: got one beside `{}`, expected it beside {}", path, key,
             when ? "when" : "at", beside);
  };
  if (when) {
    refuse({"every", "until"}, "`at`");
    read_when(all, path, scope, event);
  } else {
    refuse({"rising", "falling"}, "`when`");
    read_times(all, path, event);
  }
  if (event.condition == no_node) refuse({"initially", "persistent"}, "a condition");
  if (const Item* const name = find("name")) event.name = scalar(*name->value, path + ": name");
  read_way(all, path, scope, event);
  event.stop = is_true(all, path, "stop", false);
  if (const Item* const set = find("set")) read_resets(*set, path, scope, event);
  if (event.set.empty() && !event.stop)
    fail(node.place,
         "{}: got one that sets nothing and does not stop, expected `set: {{x: ...}}` "
         "or `stop: true`",
         path);
  for (const Item& item : all)
    if (item.key != "set" && item.key != "name")
      problem_.events_text += fmt::format("{}: {}\n", item.key, scalar(*item.value, path));
  for (const long double t : event.times) problem_.events_text += fmt::format("{:.21Lg} ", t);
  return event;
}

void Reader::read_when(const std::vector<Item>& all, const std::string& path, const Scope& scope,
                       Event& event) {
  const Item& when = *input::entry_of(all, "when");
  bool is_condition = false;
  const Id value = expression(when, path, scope, &is_condition);
  const bool rising = is_true(all, path, "rising", false),
             falling = is_true(all, path, "falling", false);
  event.initially = is_true(all, path, "initially", true);
  event.persistent = is_true(all, path, "persistent", true);
  event.name = scalar(*when.value, path);
  if (is_condition)
    for (const char* key : {"rising", "falling"})
      if (const Item* const extra = input::entry_of(all, key))
        fail(extra->key_place,
             "{}: {}: got one beside a condition, which an event happens at where it becomes true, "
             "expected `when: x - 1` in place of `when: x > 1`",
             path, key);
  if (problem_.graph.is_constant(value) && !input::entry_of(all, "initially"))
    fail(when.value->place, "{}: when: got a constant, expected an expression of states or t",
         path);
  if (is_condition) {
    event.condition = value;
    return;
  }
  if (!is_finite_at_start(problem_, value))
    fail(when.value->place, "{}: when: not finite at the start, expected a number", path);
  event.when = value;
  event.sense = static_cast<int>(rising) - static_cast<int>(falling);
  event.name += event.sense > 0 ? " rising" : event.sense < 0 ? " falling" : "";
}

/// How it is carried out: order, priority, delay.
void Reader::read_way(const std::vector<Item>& all, const std::string& path, const Scope& scope,
                      Event& event) {
  if (const Item* const order = input::entry_of(all, "order")) {
    const long double value = number(*order->value, path + ": order");
    if (value != std::round(value) || std::abs(value) > 1e9L)
      fail(order->value->place, "{}: order: got {}, expected a whole number", path,
           static_cast<double>(value));
    event.order = static_cast<int>(value);
  }
  if (const Item* const priority = input::entry_of(all, "priority"))
    event.priority = expression(*priority, path, scope);
  if (const Item* const delay = input::entry_of(all, "delay")) {
    event.delay = expression(*delay, path, scope);
    if (const Node& node = problem_.graph[event.delay];
        problem_.graph.is_constant(event.delay) && !(node.value >= 0))
      fail(delay->value->place, "{}: delay: got {}, expected a time from 0 on", path,
           static_cast<double>(node.value));
  }
  event.early = is_true(all, path, "early", false);
}

void Reader::read_times(const std::vector<Item>& all, const std::string& path, Event& event) {
  const auto find = [&](std::string_view key) { return input::entry_of(all, key); };
  const Item *const at = find("at"), *const every = find("every"), *const until = find("until");
  const long double end = problem_.stops.back(), start = problem_.t0;
  const long double first = number(*at->value, path + ": at");
  event.name = fmt::format("at {}", scalar(*at->value, path));
  if (!every) {
    if (until) fail(until->key_place, "{}: until: got one without `every`, expected both", path);
    if (first < start)
      fail(at->value->place, "{}: at: before the start; got {}, expected at least {}", path,
           static_cast<double>(first), static_cast<double>(start));
    event.times = {first};
    return;
  }
  event.name += fmt::format(" every {}", scalar(*every->value, path));
  const long double apart = number(*every->value, path + ": every");
  if (!(apart > 0))
    fail(every->value->place, "{}: every: got {}, expected a positive time", path,
         static_cast<double>(apart));
  const long double last = until ? number(*until->value, path + ": until") : end;
  if (last < first)
    fail((until ? until : at)->value->place, "{}: {}; got {}, expected at least the first time {}",
         path, until ? "until" : "at: after the end", static_cast<double>(last),
         static_cast<double>(first));
  const long double rounding = 8 * std::numeric_limits<double>::epsilon();
  const auto times_to = [&](long double t) {
    return std::floor((t - first) / apart * (1 + rounding) + rounding);
  };
  const long double farther = times_to(until ? last : problem_.events_until),
                    count = farther < most_times ? farther : times_to(last);
  if (farther >= most_times && !until) problem_.events_until = problem_.stops.back();
  if (count >= most_times)
    fail(every->value->place, "{}: every: got {} times, expected at most {}", path,
         static_cast<double>(count), most_times);
  for (long double k = 0; k <= count; ++k)
    if (const long double t = first + k * apart; t >= start) event.times.push_back(t);
}

void Reader::read_resets(const Item& set, const std::string& path, const Scope& scope,
                         Event& event) {
  for (const Item& item : items(*set.value, path + ": set")) {
    const auto state = std::ranges::find(problem_.states, item.key);
    if (state == problem_.states.end())
      fail(item.key_place, "{}: set: no state; got {}, expected a state{}", path, shown(item.key),
           near_one(item.key, problem_.states));
    event.set.emplace_back(state - problem_.states.begin(),
                           expression(item, path + ": set", scope));
    problem_.events_text += fmt::format("{} = {}\n", item.key, scalar(*item.value, path));
  }
}

void Reader::require_order() const {
  const std::vector<Event>& all = problem_.events;
  for (std::size_t b = 0; b < all.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      if (all[a].order != all[b].order || all[a].priority != all[b].priority ||
          !meet(all[a], all[b]))
        continue;
      for (const auto& [state, value] : all[b].set)
        if (std::ranges::find(all[a].set, state, &std::pair<std::size_t, Id>::first) !=
            all[a].set.end())
          fail(all[b].place,
               "events[{}]: two events set {} at one time; got this and events[{}], expected an "
               "`order` of each, a whole number, the lower first",
               b + 1, problem_.states[state], a + 1);
    }
}

}  // namespace odeum::formula::reading
