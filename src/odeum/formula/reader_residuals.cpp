// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "odeum/formula/reader.hpp"

namespace odeum::formula::reading {

using Real = long double;

Place Reader::place_of_residual(std::size_t residual) const {
  return residual < residual_places_.size()
             ? residual_places_[residual]
             : section(section("residuals") ? "residuals" : "constraints")->value->place;
}

void Reader::read_residual_list(const char* in, const char* one, const Scope& scope,
                                std::vector<Id>& residuals) {
  const YamlNode& list = *section(in)->value;
  if (list.kind != YamlNode::Kind::sequence || list.items.empty())
    fail(list.place,
         "{}: got {}, expected a list of expressions, each zero along the "
         "solution",
         in, list.kind_name());
  std::size_t number = 0;
  for (const auto& each : list.items) {
    residual_places_.push_back(each->place);
    residual_names_.push_back(fmt::format("{} {}", one, ++number));
    residuals.push_back(
        expression({fmt::format("{}: {}", in, number), each->place, each.get()}, "", scope));
    problem_.equations_text += (residuals.size() == 1 ? "0 = " : ", 0 = ") + each->text;
  }
}

// The rate of a state that is among the states is that state.
std::vector<Id> Reader::residuals_of(const Scope& all) {
  const YamlNode& list = *section("residuals")->value;
  for (const char* other : {"equations", "mass", "reactions", "constraints"})
    if (const Item* const item = section(other))
      fail(item->key_place, "{0}: beside residuals; got both, expected the residuals alone", other);
  Graph& graph = problem_.graph;
  Scope scope = all;
  std::vector<Id> definitions;
  std::map<std::string, Array, std::less<>> rates;
  for (std::uint32_t k = 0; k < problem_.states.size(); ++k) {
    const std::string& name = problem_.states[k];
    const Id rate = graph.state(first_rate + k);
    if (const std::size_t bracket = name.find('['); bracket != std::string::npos) {
      Array& array = rates[name.substr(0, bracket) + "'"];
      array.first = first_of_.at(name.substr(0, bracket));
      array.elements.push_back(rate);
    } else if (const auto state = scope.names.find(name + "'"); state != scope.names.end()) {
      definitions.push_back(graph.make(Op::subtract, rate, state->second));
    } else {
      scope.names[name + "'"] = rate;
    }
  }
  scope.arrays.insert(rates.begin(), rates.end());
  const std::size_t expected = problem_.states.size() - definitions.size();
  std::vector<Id> residuals;
  read_residual_list("residuals", "residual", scope, residuals);
  if (residuals.size() != expected)
    fail(list.place,
         "residuals: {} {}; got {}, expected {}: one for each state whose rate is not a "
         "state",
         std::max(expected, residuals.size()) - std::min(expected, residuals.size()),
         residuals.size() < expected ? "short" : "too many", residuals.size(), expected);
  residuals.insert(residuals.end(), definitions.begin(), definitions.end());
  return residuals;
}

std::vector<Id> Reader::equations_and_constraints(const Scope& scope) {
  for (const char* other : {"mass", "reactions", "implicit"})
    if (const Item* const item = section(other))
      fail(item->key_place, "{0}: beside constraints; got both, expected equations and constraints",
           other);
  Graph& graph = problem_.graph;
  std::vector<Place> places;
  const std::vector<Id> equations = read_by_state("equations", scope, places);
  std::vector<Id> residuals;
  std::vector<std::string> without;
  for (std::uint32_t k = 0; k < equations.size(); ++k) {
    if (equations[k] == no_node) {
      without.push_back(problem_.states[k]);
      continue;
    }
    residuals.push_back(graph.make(Op::subtract, graph.state(first_rate + k), equations[k]));
    residual_places_.push_back(places[k]);
    residual_names_.push_back("the equation of " + problem_.states[k]);
  }
  for (const Item& item : items("equations"))
    problem_.equations_text +=
        fmt::format("{}{}' = {}", problem_.equations_text.empty() ? "" : ", ", item.key,
                    item.value->text.size() > 200 ? "..." : item.value->text);
  const std::size_t given = residuals.size();
  read_residual_list("constraints", "constraint", scope, residuals);
  if (residuals.size() != equations.size())
    fail(
        section("constraints")->value->place,
        "constraints: got {}, expected {}: one for each state without an equation{}",
        residuals.size() - given, without.size(),
        without.empty() || without.size() > 8 ? "" : fmt::format(", {}", fmt::join(without, ", ")));
  return residuals;
}

// A rate that no symbols solve for becomes a state, on which its residual is a constraint.
void Reader::add_rates_as_states(std::vector<Id>& residuals) {
  Graph& graph = problem_.graph;
  std::map<std::uint32_t, Id> by;
  for (const std::uint32_t k : nonlinear_rates(graph, residuals)) {
    const std::string of = problem_.states[k], name = of + "'";
    const auto added = static_cast<std::uint32_t>(problem_.states.size());
    by[first_rate + k] = graph.state(added);
    unknown_.insert(added);
    problem_.states.push_back(name);
    problem_.start.push_back(graph.constant(0));
    problem_.y0.push_back(0);
    group_places_[name] = group_places_.at(of.substr(0, of.find('[')));
  }
  residuals = with_states_replaced(graph, residuals, by);
  for (const auto& [rate, state] : by)
    residuals.push_back(graph.make(Op::subtract, graph.state(rate), state));
}

void Reader::require_determined(const std::vector<Id>& residuals) const {
  std::vector<bool> occurs(problem_.states.size());
  for (const Id id : problem_.graph.needed(residuals)) {
    const Node& node = problem_.graph[id];
    if (node.op == Op::state)
      occurs[node.index >= first_rate ? node.index - first_rate : node.index] = true;
  }
  for (std::size_t i = 0; i < residual_places_.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (residuals[i] == residuals[k])
        fail(
            residual_places_[i],
            "{0}: {1}: written twice; got the expression of {2} again, expected an independent one",
            section("residuals") ? "residuals" : "constraints", residual_names_[i],
            residual_names_[k]);
  for (std::size_t k = 0; k < occurs.size(); ++k)
    if (!occurs[k])
      fail(group_places_.at(problem_.states[k].substr(0, problem_.states[k].find('['))),
           "states: one that nothing determines; got {0} in none of the {1}, expected it, or its "
           "rate, in one of them",
           problem_.states[k], section("residuals") ? "residuals" : "equations and constraints");
}

void Reader::require_rates() {
  std::vector<Real> found(problem_.states.size());
  Evaluator<Real>(problem_.graph, problem_.equations)(problem_.t0, problem_.y0.data(),
                                                      found.data());
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < given_states_; ++k)
    texts.push_back(fmt::format("{}' = {:.9Lg}", problem_.states[k], found[k] + 0.L));
  for (std::size_t k = 0; k < problem_.states.size(); ++k)
    if (unknown_.contains(k))
      texts.push_back(fmt::format("{} = {:.15Lg}, found", problem_.states[k], problem_.y0[k]));
  if (texts.size() <= 16)
    problem_.notes.emplace_back("start", fmt::format("{}", fmt::join(texts, ", ")));
  std::vector<Place> places;
  const std::vector<Id> given = read_by_state("rates", constants_, places);
  constexpr Real agreement = 1e-6L;
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (given[k] == no_node) continue;
    const Real value = problem_.graph[given[k]].value;
    if (std::abs(value - found[k]) <= agreement * std::max(std::abs(value), std::abs(found[k])))
      continue;
    fail(places[k],
         "rates: {}: not what {} says at the start; got {:.9Lg}, expected "
         "{:.9Lg}",
         problem_.states[k], residual_names_.at(residual_of_[k]), value, found[k]);
  }
}

void Reader::read_residuals(const Scope& scope) {
  given_states_ = problem_.states.size();
  std::vector<Id> residuals =
      section("residuals") ? residuals_of(scope) : equations_and_constraints(scope);
  require_determined(residuals);
  add_rates_as_states(residuals);
  std::vector<Place> unused;
  const std::vector<Id> guesses = read_by_state("rates", constants_, unused);
  for (std::size_t k = 0; k < given_states_; ++k)
    for (std::size_t added = given_states_; added < problem_.states.size(); ++added)
      if (guesses[k] != no_node && problem_.states[added] == problem_.states[k] + "'")
        problem_.y0[added] = problem_.graph[guesses[k]].value;
  try {
    const auto reduced = [&](bool is_start) {
      return reduce(problem_.graph, residuals, problem_.states, problem_.t0, problem_.y0, is_start);
    };
    find_start(reduced(unknown_.empty()).constraints);
    const Reduction reduction = reduced(true);
    require_constraints(reduction.constraints);
    problem_.equations = reduction.rates;
    problem_.index = reduction.index;
    if (reduction.index > 1) problem_.indices = indices_of(reduction, problem_.graph);
    residual_of_ = reduction.by;
    // A constraint that is a difference of residuals is lost in the rounding of their rates where
    // steps are short: it stands in place of one of them.
    if (!reduction.constraints.empty()) problem_.residuals = residuals;
    for (const Constraint& constraint : reduction.constraints) {
      if (constraint.level == 0) problem_.residuals[constraint.own] = constraint.value;
      problem_.constraints.push_back({name_of(constraint), constraint.value, constraint.level > 0});
    }
    for (const std::size_t by : reduction.by) problem_.places.push_back(place_of_residual(by));
    note_residuals(reduction);
    find_jumps();
    add_drift();
    require_rates();
  } catch (const ReductionError& error) {
    const std::size_t at = error.residual();
    fail(place_of_residual(at), "{}: {}: {}", section("residuals") ? "residuals" : "constraints",
         name_of({.value = no_node, .of = {at}, .own = at}), error.what());
  }
}

}  // namespace odeum::formula::reading
