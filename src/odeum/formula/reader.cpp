// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "odeum/input/near_words.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum::formula {
namespace {

// `case` and `cases` are read by CaseSection.
constexpr std::string_view known_keys[] = {
    "name",         "parameters", "definitions", "states", "equations", "boundaries",
    "time",         "exact",      "invariants",  "scale",  "tolerance", "mass",
    "residuals",    "rates",      "implicit",    "case",   "cases",     "reactions",
    "compartments", "outputs",    "events",      "tables", "inputs",    "constraints"};

}  // namespace

namespace reading {

Reader::Reader(const std::string& file, const std::string& text, const Overrides& overrides,
               Parameters kind)
    : Source(file, text), overrides_(overrides), kind_(kind) {
  problem_.file = file;
}

Problem Reader::read() {
  sections_ = items(root(), "", known_keys);
  if (const Item* const name = section("name")) problem_.name = scalar(*name->value, "name");
  constants_.refused["t"] = "a constant";
  read_parameters();
  read_tables();
  read_compartments();
  read_states();
  read_time();
  Scope all = constants_;
  all.refused.clear();
  all.span = {problem_.t0, problem_.stops.back()};
  add_states(all);
  read_inputs(all);
  read_definitions(all);
  read_boundaries(all);
  if (is_implicit())
    read_residuals(all);
  else
    read_equations(all);
  read_implicit(all);
  read_mass(all);
  read_events(all);
  read_exact();
  read_invariants(all);
  read_outputs(all);
  read_scale();
  read_tolerance();
  require_start();
  require_exact();
  return std::move(problem_);
}

std::vector<Item> Reader::items(const std::string& key) const {
  const Item* const found = section(key);
  return found ? items(*found->value, key) : std::vector<Item>{};
}

std::vector<Item> Reader::required_items(const std::string& key) const {
  const Item* const found = section(key);
  if (!found) fail({}, "{0}: missing; got no such key, expected `{0}: {{x: ...}}`", key);
  std::vector<Item> all = items(*found->value, key);
  if (all.empty()) fail(found->value->place, "{}: empty; got none, expected one at least", key);
  return all;
}

void Reader::require_new(const Item& item, const std::string& in, const std::string& name) {
  if (const std::string fault = fault_of_name(name); !fault.empty())
    fail(item.key_place, "{}: {}", in, fault);
  const auto [at, added] = names_.try_emplace(name, in);
  if (!added)
    fail(item.key_place, "{}: a name twice; got {}, which is also among the {}, expected another",
         in, name, at->second);
}

void Reader::read_parameters() {
  const std::vector<Item> all = items("parameters");
  for (const Item& item : all) require_new(item, "parameters", item.key);
  for (const auto& [name, value] : overrides_)
    if (!names_.contains(name)) {
      std::vector<std::string> candidates;
      for (const Item& item : all) candidates.push_back(item.key);
      fail(section("parameters") ? section("parameters")->key_place : Place{},
           "parameters: none to set of that name; got --set {}={}, expected {}", shown(name),
           shown(value),
           candidates.empty() ? "no --set: the file has no parameters" : one_of(candidates, name));
    }
  for (const Item& item : all) constants_.refused[item.key] = "a parameter that stands above";
  for (const Item& item : all) {
    const std::string key = "parameters: " + item.key;
    const auto set = overrides_.find(item.key);
    const long double value = set == overrides_.end() ? number(*item.value, key)
                                                      : number({.kind = YamlNode::Kind::scalar,
                                                                .place = item.key_place,
                                                                .text = set->second,
                                                                .items = {}},
                                                               key + " (--set)");
    problem_.parameters[item.key] = value;
    constants_.refused.erase(item.key);
    constants_.names[item.key] = kind_ == Parameters::numbers
                                     ? problem_.graph.constant(value)
                                     : problem_.graph.named(value, item.key);
  }
}

void Reader::read_time() {
  const Item* const time = section("time");
  if (!time) fail({}, "time: missing; got no such key, expected `time: {{end: 20}}`");
  constexpr std::string_view keys[] = {"end", "start", "stops"};
  const std::vector<Item> all = items(*time->value, "time", keys);
  const Item *const start = input::entry_of(all, "start"), *const end = input::entry_of(all, "end"),
                    *const stops = input::entry_of(all, "stops");
  if (start) problem_.t0 = number(*start->value, "time: start");
  if (!end) fail(time->value->place, "time: end: missing; got none, expected a time");
  const auto last = static_cast<double>(number(*end->value, "time: end"));
  const auto first = static_cast<double>(problem_.t0);
  problem_.t0 = first;
  if (!(last > first))
    fail(end->value->place, "time: end: not after the start; got {}, expected more than {}", last,
         first);
  if (stops)
    read_stops(*stops->value, first, last);
  else
    for (int k = 1; k <= 4; ++k)
      problem_.stops.push_back(k == 4 ? last : first + (last - first) * k / 4);
}

void Reader::read_stops(const YamlNode& list, double first, double last) {
  if (list.kind != YamlNode::Kind::sequence || list.items.empty())
    fail(list.place, "time: stops: got {}, expected a list of times", list.kind_name());
  double before = first;
  for (const auto& item : list.items) {
    const auto stop = static_cast<double>(number(*item, "time: stops"));
    if (!(stop > before) || stop > last)
      fail(item->place,
           "time: stops: outside or not ascending; got {}, expected more than {} and at most the "
           "end {}",
           stop, before, last);
    problem_.stops.push_back(before = stop);
  }
  if (problem_.stops.size() > 1000)
    fail(list.place, "time: stops: too many; got more than 1000, expected fewer");
  if (problem_.stops.back() < last) problem_.stops.push_back(last);
}

void Reader::read_definitions(Scope& scope) {
  const std::vector<Item> all = items("definitions");
  for (const Item& item : all) {
    require_new(item, "definitions", item.key);
    if (item.key == "i" && !first_of_.empty())
      fail(
          item.key_place,
          "definitions: i is the index of indexed states; got a definition of it, expected another "
          "name");
    scope.refused[item.key] =
        "one that stands above (definitions are computed in their order; two "
        "that need each other are cyclic)";
  }
  for (const Item& item : all) {
    const Id id = expression(item, "definitions", scope);
    scope.refused.erase(item.key);
    scope.names[item.key] = id;
  }
}

}  // namespace reading

using namespace reading;

Problem read_problem(const std::string& file, const std::string& text, const Overrides& overrides,
                     Parameters kind) {
  return Reader(file, text, overrides, kind).read();
}

std::string problem_text(const std::string& file) {
  return read_text_file(file, "problem", most_problem_bytes);
}

bool looks_like_problem(const std::string& file, const std::string& text) {
  const std::vector<std::string> own{"equations", "residuals", "states", "reactions"};
  // Also where the rest is not YAML: the error is then that of a problem.
  for (const std::string& key : own)
    if (text.starts_with(key + ':') || text.find('\n' + key + ':') != std::string::npos)
      return true;
  try {
    const Source source(file, text);
    const std::vector<Item> all = source.items(source.root(), "problem");
    // A key that is spelt wrongly is one too, unless bodies make it a scene: the error is then
    // about keys of problems.
    const auto has_one = [&](const auto& is_meant) { return std::ranges::any_of(all, is_meant); };
    return has_one([&](const Item& item) { return !near_one(item.key, own).empty(); }) &&
           !has_one([](const Item& item) {
             return item.key == "particles" || item.key == "cloth" || item.key == "emitters";
           });
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace odeum::formula
