// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/formula/evaluator.hpp"
#include "odeum/formula/reader.hpp"
#include "odeum/input/near_words.hpp"

namespace odeum::formula::reading {
namespace {

constexpr std::string_view keys[] = {"name",  "when",  "rising", "falling", "at",
                                     "every", "until", "set",    "stop",    "order"};
constexpr std::size_t most_times = 100'000;

bool both_ways(const Event& a, const Event& b) {
  return a.sense == 0 || b.sense == 0 || a.sense == b.sense;
}

/// Whether two events happen at once wherever one of them does, or at one time at least.
bool meet(const Event& a, const Event& b) {
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
  for (const auto& item : list->value->items)
    problem_.events.push_back(read_event(*item, problem_.events.size() + 1, scope));
  require_order();
  for (const Item& item : items("definitions"))
    problem_.events_text += fmt::format("{} = {}\n", item.key, scalar(*item.value, item.key));
  for (const auto& [name, value] : problem_.parameters)
    problem_.events_text += fmt::format("{} {:.21Lg}\n", name, value);
}

Event Reader::read_event(const YamlNode& node, std::size_t place, const Scope& scope) {
  const std::string path = fmt::format("events[{}]", place);
  const std::vector<Item> all = items(node, path, keys);
  const auto find = [&](std::string_view key) { return input::entry_of(all, key); };
  const auto is_true = [&](std::string_view key) {
    const Item* const item = find(key);
    if (!item) return false;
    const std::string text = scalar(*item->value, path + ": " + item->key);
    if (text != "true" && text != "false")
      fail(item->value->place, "{}: {}: got {}, expected true or false", path, key, shown(text));
    return text == "true";
  };
  Event event;
  event.place = node.place;
  const Item *const when = find("when"), *const at = find("at");
  if (!when == !at)
    fail(node.place, "{}: got {}, expected `when: expression` or `at: time`", path,
         when ? "both when and at" : "neither when nor at");
  const bool rising = is_true("rising"), falling = is_true("falling");
  if (when) {
    for (const char* key : {"every", "until"})
      if (const Item* const extra = find(key))
        fail(extra->key_place, "{}: {}: got one beside `when`, expected it beside `at`", path, key);
    event.when = expression(*when, path, scope);
    if (problem_.graph.is_constant(event.when))
      fail(when->value->place, "{}: when: got a constant, expected an expression of states or t",
           path);
    if (!is_finite_at_start(problem_, event.when))
      fail(when->value->place, "{}: when: not finite at the start, expected a number", path);
    event.sense = static_cast<int>(rising) - static_cast<int>(falling);
    event.name = scalar(*when->value, path) + (event.sense > 0   ? " rising"
                                               : event.sense < 0 ? " falling"
                                                                 : "");
  } else {
    for (const char* key : {"rising", "falling"})
      if (const Item* const extra = find(key))
        fail(extra->key_place, "{}: {}: got one beside `at`, expected it beside `when`", path, key);
    read_times(all, path, event);
  }
  if (const Item* const name = find("name")) event.name = scalar(*name->value, path + ": name");
  if (const Item* const order = find("order")) {
    const long double value = number(*order->value, path + ": order");
    if (value != std::round(value) || std::abs(value) > 1000)
      fail(order->value->place, "{}: order: got {}, expected a whole number", path,
           static_cast<double>(value));
    event.order = static_cast<int>(value);
  }
  event.stop = is_true("stop");
  if (const Item* const set = find("set")) read_resets(*set, path, scope, event);
  if (event.set.empty() && !event.stop)
    fail(node.place,
         "{}: got one that sets nothing and does not stop, expected `set: {{x: ...}}` "
         "or `stop: true`",
         path);
  problem_.events_text += fmt::format("{} {} {} {}\n", when ? scalar(*when->value, path) : "at",
                                      event.sense, event.stop, event.order);
  for (const long double t : event.times) problem_.events_text += fmt::format("{:.21Lg} ", t);
  return event;
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
  const long double count = std::floor((last - first) / apart * (1 + rounding) + rounding);
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
      if (all[a].order != all[b].order || !meet(all[a], all[b])) continue;
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
