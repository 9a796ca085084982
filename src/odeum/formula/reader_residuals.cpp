// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "odeum/formula/consistent_start.hpp"
#include "odeum/formula/reader.hpp"

namespace odeum::formula::reading {

using Real = long double;

std::string Reader::name_of(const std::set<std::size_t>& residuals) const {
  std::vector<std::size_t> numbers;
  for (const std::size_t k : residuals)
    if (k < residual_places_.size()) numbers.push_back(k + 1);
  return numbers.size() == 1 ? fmt::format("residual {}", numbers.front())
                             : fmt::format("residuals {} together", fmt::join(numbers, ", "));
}

Place Reader::place_of_residual(std::size_t residual) const {
  return residual < residual_places_.size() ? residual_places_[residual]
                                            : section("residuals")->value->place;
}

// The rate of a state that is among the states is that state.
std::vector<Id> Reader::residuals_of(const Scope& all) {
  const YamlNode& list = *section("residuals")->value;
  for (const char* other : {"equations", "mass", "reactions"})
    if (const Item* const item = section(other))
      fail(item->key_place, "{0}: beside residuals; got both, expected the residuals alone", other);
  if (list.kind != YamlNode::Kind::sequence || list.items.empty())
    fail(list.place,
         "residuals: got {}, expected a list of expressions, each zero along the "
         "solution",
         list.kind_name());
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
  for (const auto& each : list.items) {
    residual_places_.push_back(each->place);
    residuals.push_back(
        expression({fmt::format("residuals: {}", residual_places_.size()), each->place, each.get()},
                   "", scope));
    problem_.equations_text += (residuals.size() == 1 ? "0 = " : ", 0 = ") + each->text;
  }
  if (residuals.size() != expected)
    fail(list.place,
         "residuals: {} {}; got {}, expected {}: one for each state whose rate is not a "
         "state",
         std::max(expected, residuals.size()) - std::min(expected, residuals.size()),
         residuals.size() < expected ? "short" : "too many", residuals.size(), expected);
  residuals.insert(residuals.end(), definitions.begin(), definitions.end());
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

void Reader::find_start(const std::vector<Constraint>& constraints) {
  const std::vector<std::size_t> unknown(unknown_.begin(), unknown_.end());
  if (unknown.empty()) return;
  std::vector<Id> roots;
  for (const Constraint& constraint : constraints)
    for (const Id id : problem_.graph.needed({constraint.value})) {
      const Node& node = problem_.graph[id];
      if (node.op != Op::state || !unknown_.contains(node.index)) continue;
      roots.push_back(constraint.value);
      break;
    }
  if (roots.size() != unknown.size())
    fail(section("states")->value->place,
         "states: {} of unknown start; got {} constraints on them, expected as many",
         unknown.size(), roots.size());
  const std::vector<Real> given = problem_.y0;
  for (const Real guess : {0.L, 1.L, -1.L, 0.1L, 10.L}) {
    std::vector<Real> y = given;
    for (const std::size_t k : unknown)
      if (y[k] == 0) y[k] = guess;
    if (!find_roots(problem_.graph, roots, problem_.t0, y, unknown)) continue;
    problem_.y0 = y;
    for (const std::size_t k : unknown) problem_.start[k] = problem_.graph.constant(y[k]);
    return;
  }
  fail(section("residuals")->value->place,
       "residuals: no start was found for {}; got none by Newton's method from several guesses, "
       "expected values among the states",
       problem_.states[unknown.front()]);
}

void Reader::require_constraints(const std::vector<Constraint>& constraints) {
  constexpr Real rounding = 1e-12L;
  for (const Constraint& constraint : constraints) {
    const Linearised at =
        linearise(problem_.graph, {constraint.value}, problem_.t0, problem_.y0, {});
    if (std::abs(at.values[0]) <= rounding * at.sizes[0]) continue;
    fail(place_of_residual(*constraint.of.begin()),
         "residuals: {}, a constraint, {} not zero at the start; got {:.9Lg}, expected 0: another "
         "start, or ~ for a state that is to be found",
         name_of(constraint.of), constraint.of.size() > 1 ? "are" : "is", at.values[0]);
  }
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
         "rates: {}: not what residual {} says at the start; got {:.9Lg}, expected "
         "{:.9Lg}",
         problem_.states[k], residual_of_[k] + 1, value, found[k]);
  }
}

void Reader::note_residuals(const Reduction& reduction) {
  const std::size_t count = residual_places_.size();
  if (reduction.constraints.empty()) {
    problem_.notes.emplace_back(
        "residuals",
        fmt::format("{}, solved for all rates: an ordinary problem, which every solver takes",
                    count));
    return;
  }
  const bool implicit = problem_.states.size() > given_states_;
  for (const Constraint& constraint : reduction.constraints) {
    std::vector<std::string> gives;
    for (std::size_t k = 0; k < problem_.states.size(); ++k)
      if (reduction.by[k] == constraint.own) gives.push_back(problem_.states[k] + "'");
    const std::size_t first = *constraint.of.begin();
    bool is_rate = false;
    for (const Id id : problem_.graph.needed({constraint.value}))
      is_rate = is_rate ||
                (problem_.graph[id].op == Op::state && problem_.graph[id].index >= given_states_);
    problem_.notes.emplace_back(
        "residuals",
        is_rate && first < count
            ? fmt::format("{} cannot be solved for its rate in symbols: the rate is a state too",
                          name_of(constraint.of))
            : fmt::format("{}: a constraint without rates, index 1; its derivative gives {}",
                          name_of(constraint.of), fmt::join(gives, ", ")));
  }
  problem_.notes.emplace_back(
      "residuals", fmt::format("{} of {} are differentiated once, so that every solver of ordinary "
                               "problems takes them; what a run lets {} drift is part of its error",
                               reduction.constraints.size(), count,
                               implicit ? "the residuals" : "the constraints"));
}

void Reader::read_residuals(const Scope& scope) {
  given_states_ = problem_.states.size();
  std::vector<Id> residuals = residuals_of(scope);
  add_rates_as_states(residuals);
  std::vector<Place> unused;
  const std::vector<Id> guesses = read_by_state("rates", constants_, unused);
  for (std::size_t k = 0; k < given_states_; ++k)
    for (std::size_t added = given_states_; added < problem_.states.size(); ++added)
      if (guesses[k] != no_node && problem_.states[added] == problem_.states[k] + "'")
        problem_.y0[added] = problem_.graph[guesses[k]].value;
  try {
    const std::vector<Constraint> constraints =
        constraints_of(problem_.graph, residuals, problem_.states, problem_.t0, problem_.y0);
    find_start(constraints);
    require_constraints(constraints);
    const Reduction reduction =
        reduce(problem_.graph, residuals, problem_.states, problem_.t0, problem_.y0);
    problem_.equations = reduction.rates;
    residual_of_ = reduction.by;
    // A constraint that is a difference of residuals is lost in the rounding of their rates where
    // steps are short: it stands in place of one of them.
    if (!reduction.constraints.empty()) problem_.residuals = residuals;
    for (const Constraint& constraint : reduction.constraints)
      problem_.residuals[constraint.own] = constraint.value;
    for (const std::size_t by : reduction.by) problem_.places.push_back(place_of_residual(by));
    note_residuals(reduction);
    require_rates();
  } catch (const ReductionError& error) {
    fail(place_of_residual(error.residual()), "residuals: {}: {}", name_of({error.residual()}),
         error.what());
  }
}

}  // namespace odeum::formula::reading
