// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "odeum/formula/reader.hpp"
#include "odeum/input/near_words.hpp"

namespace odeum::formula::reading {
namespace {

/// The name of an indexed state without its index, of another one itself.
std::string group_of(const std::string& state) { return state.substr(0, state.find('[')); }

std::string on_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

void Reader::add_state(const Item& item, const std::string& name) {
  if (problem_.states.size() >= most_states)
    fail(item.key_place, "states: too many; got more than {}, expected at most that", most_states);
  if (item.value->kind == YamlNode::Kind::null && is_implicit()) {
    unknown_.insert(problem_.states.size());
    problem_.start.push_back(problem_.graph.constant(0));
  } else {
    problem_.start.push_back(constant(*item.value, "states: " + item.key));
  }
  problem_.states.push_back(name);
  problem_.y0.push_back(problem_.graph[problem_.start.back()].value);
}

void Reader::require_rate(const Item& item, const std::string& of) {
  if (!group_places_.contains(of) || first_of_.contains(of))
    fail(item.key_place,
         "states: the rate of an unknown state; got {}, expected a state {} before it",
         shown(item.key), of);
}

void Reader::read_states() {
  for (const Item& item : required_items("states")) {
    const Key key = read_key(item, "states");
    if (const std::string_view name = key.name; name.ends_with('\''))
      require_rate(item, std::string(name.substr(0, name.size() - 1)));
    else
      require_new(item, "states", key.name);
    group_places_[key.name] = item.key_place;
    if (!key.indexed) {
      add_state(item, key.name);
      continue;
    }
    if (names_.contains("i"))
      fail(item.key_place,
           "states: i is the index of indexed states; got another i among the {}, expected another "
           "name for that",
           names_.at("i"));
    constants_.refused["i"] = "an expression for indexed states";
    first_of_[key.name] = key.first;
    for (std::int64_t k = key.first; k <= key.last; ++k) {
      constants_.index = k;
      add_state(item, fmt::format("{}[{}]", key.name, k));
    }
    constants_.index.reset();
  }
}

void Reader::add_states(Scope& scope) {
  for (std::uint32_t k = 0; k < problem_.states.size(); ++k) {
    const std::string& name = problem_.states[k];
    const Id id = problem_.graph.state(k);
    const std::string group = group_of(name);
    if (group == name) {
      scope.names[name] = id;
    } else {
      Array& array = scope.arrays[group];
      array.first = first_of_.at(group);
      array.elements.push_back(id);
    }
  }
}

void Reader::read_boundaries(Scope& scope) {
  std::map<std::string, Array, std::less<>> with = scope.arrays;
  for (const Item& item : items("boundaries")) {
    const Key key = read_key(item, "boundaries");
    const auto found = with.find(key.name);
    if (!key.indexed || found == with.end())
      fail(item.key_place,
           "boundaries: no indexed state; got {}, expected an index beyond the ends of one, like "
           "u[0]",
           shown(item.key));
    Array& array = found->second;
    if (key.last - key.first >= 1000)
      fail(item.key_place, "boundaries: too many; got more than 1000, expected fewer");
    for (std::int64_t k = key.first; k <= key.last; ++k) {
      if (k >= array.first && k <= array.last())
        fail(item.key_place,
             "boundaries: a state; got {}[{}], expected an index below {} or above {}", key.name, k,
             array.first, array.last());
      scope.index = k;
      const Id id = expression(item, "boundaries", scope);
      if (!array.beyond.emplace(k, id).second)
        fail(item.key_place, "boundaries: given twice; got {}[{}], expected it once", key.name, k);
    }
    scope.index.reset();
  }
  scope.arrays = std::move(with);
}

std::vector<Id> Reader::read_by_state(const std::string& in, Scope scope,
                                      std::vector<Place>& places) {
  std::vector<Id> nodes(problem_.states.size(), no_node);
  places.resize(nodes.size());
  std::vector<std::string> groups;
  for (const auto& [name, place] : group_places_) groups.push_back(name);
  std::unordered_map<std::string_view, std::size_t> position;
  for (std::size_t k = 0; k < nodes.size(); ++k) position[problem_.states[k]] = k;
  for (const Item& item : items(in)) {
    const Key key = read_key(item, in);
    if (!group_places_.contains(key.name))
      fail(item.key_place, "{}: no state; got {}, expected a state{}", in, shown(item.key),
           near_one(key.name, groups));
    const bool has_index = first_of_.contains(key.name);
    if (has_index != key.indexed)
      fail(item.key_place, "{}: {}; got {}, expected {}", in,
           has_index ? "an index is missing" : "the state has no index", shown(item.key),
           has_index ? key.name + "[first..last]" : key.name);
    for (std::int64_t k = key.first; k <= key.last; ++k) {
      const std::string name = key.indexed ? fmt::format("{}[{}]", key.name, k) : key.name;
      const auto at = position.find(name);
      if (at == position.end())
        fail(item.key_place, "{}: an index out of range; got {}, expected the states of {}", in,
             name, key.name);
      const std::size_t state = at->second;
      if (nodes[state] != no_node)
        fail(item.key_place, "{}: given twice; got {}, expected it once", in, name);
      scope.index = key.indexed ? std::optional(k) : std::nullopt;
      scope.repeats = std::min(static_cast<std::size_t>(key.last - k) + 1, nodes.size());
      nodes[state] = expression(item, in, scope);
      places[state] = item.value->place;
    }
  }
  return nodes;
}

void Reader::require_all(const std::string& in, const std::vector<Id>& nodes) {
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (nodes[k] == no_node)
      fail(group_places_.at(group_of(problem_.states[k])),
           "{0}: missing for a state; got none for {1}, expected `{1}: ...` in {0}", in,
           problem_.states[k]);
}

void Reader::read_equations(const Scope& scope) {
  if (!section("reactions")) required_items("equations");
  problem_.equations = read_by_state("equations", scope, problem_.places);
  if (section("reactions")) read_reactions(scope);
  require_all("equations", problem_.equations);
  for (const Item& item : items("equations"))
    problem_.equations_text +=
        fmt::format("{}{}' = {}", problem_.equations_text.empty() ? "" : ", ", item.key,
                    item.value->text.size() > 200 ? "..." : on_one_line(item.value->text));
}

void Reader::read_exact() {
  if (!section("exact")) return;
  Scope scope = constants_;
  scope.refused.erase("t");
  for (const std::string& name : problem_.states)
    scope.refused[group_of(name)] = "t and parameters: a closed form has no states";
  problem_.exact = read_by_state("exact", scope, problem_.exact_places);
  require_all("exact", problem_.exact);
}

void Reader::read_invariants(const Scope& scope) {
  for (const Item& item : items("invariants")) {
    if (const std::string fault = fault_of_name(item.key); !fault.empty())
      fail(item.key_place, "invariants: {}", fault);
    Scope without_time = scope;
    without_time.refused["t"] = "states and parameters";
    problem_.invariants.push_back(
        {item.key, expression(item, "invariants", without_time), item.value->place});
  }
}

void Reader::read_outputs(const Scope& scope) {
  const Item* const given = section("outputs");
  if (!given) return;
  std::vector<Item> all;
  if (given->value->kind == YamlNode::Kind::sequence)
    for (const auto& each : given->value->items)
      all.push_back({scalar(*each, "outputs"), each->place, each.get()});
  else
    all = items("outputs");
  std::set<std::string> names(problem_.states.begin(), problem_.states.end());
  for (const Output& output : problem_.outputs) names.insert(output.name);
  for (const Item& item : all) {
    // Taken words may name a column: nothing refers to it.
    if (item.key.empty() || !begins_name(item.key[0]) ||
        !std::ranges::all_of(item.key, continues_name))
      fail(item.key_place, "outputs: not a name; got {}, expected letters, digits and _",
           shown(item.key));
    if (!names.insert(item.key).second)
      fail(item.key_place, "outputs: a column twice; got {}, expected no state, and it once",
           item.key);
    problem_.outputs.push_back({item.key, expression(item, "outputs", scope)});
  }
}

void Reader::read_scale() {
  if (!section("scale")) return;
  problem_.scale.assign(problem_.states.size(), 1);
  std::vector<Place> places;
  const std::vector<Id> nodes = read_by_state("scale", constants_, places);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (nodes[k] == no_node) continue;
    const bool constant = problem_.graph.is_constant(nodes[k]);
    const double value = constant ? static_cast<double>(problem_.graph[nodes[k]].value) : 0;
    if (!(value > 0))
      fail(places[k], "scale: {}: got {}, expected a positive number", problem_.states[k], value);
    problem_.scale[k] = value;
  }
}

void Reader::read_tolerance() {
  const auto positive = [this](const YamlNode& value, const std::string& key) {
    const auto given = static_cast<double>(number(value, key));
    if (!(given > 0)) fail(value.place, "{}: got {}, expected a positive number", key, given);
    return given;
  };
  const Item* const given = section("tolerance");
  if (!given) return;
  constexpr std::string_view keys[] = {"relative", "absolute"};
  double relative = 0;
  std::vector<double> absolute;
  for (const auto& [key, place, value] : items(*given->value, "tolerance", keys)) {
    const std::string path = "tolerance: " + key;
    if (key == "relative") {
      relative = positive(*value, path);
    } else if (value->kind == YamlNode::Kind::sequence) {
      for (const auto& each : value->items) absolute.push_back(positive(*each, path));
      if (absolute.size() != problem_.states.size())
        fail(value->place, "{}: got {} numbers, expected one, or {}: one for each state", path,
             absolute.size(), problem_.states.size());
    } else {
      absolute = {positive(*value, path)};
    }
  }
  if (relative == 0)
    fail(
        given->value->place,
        "tolerance: got no relative one, expected `tolerance: {{relative: 1e-6, absolute: 1e-9}}`");
  problem_.tolerance = {relative, absolute};
}

}  // namespace odeum::formula::reading
