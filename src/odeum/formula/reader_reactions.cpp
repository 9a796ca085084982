// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/formula/reaction_text.hpp"
#include "odeum/formula/reader.hpp"
#include "odeum/formula/stoichiometry.hpp"
#include "odeum/input/near_words.hpp"

namespace odeum::formula::reading {
namespace {

/// In pairs, so that no derivative is that of a long chain of sums.
Id sum_of(Graph& graph, std::vector<Id> terms) {
  while (terms.size() > 1) {
    std::vector<Id> sums;
    for (std::size_t k = 0; k < terms.size(); k += 2)
      sums.push_back(k + 1 < terms.size() ? graph.make(Op::add, terms[k], terms[k + 1]) : terms[k]);
    terms = std::move(sums);
  }
  return terms.empty() ? graph.constant(0) : terms.front();
}

constexpr std::size_t most_summed = 5000;  // conserved sums of more species take seconds

}  // namespace

void Reader::read_compartments() {
  constexpr std::string_view keys[] = {"volume", "species"};
  for (const Item& item : items("compartments")) {
    require_new(item, "compartments", item.key);
    const std::string path = "compartments: " + item.key;
    const std::vector<Item> given = items(*item.value, path, keys);
    const Item *const volume = input::entry_of(given, "volume"), *const species = input::entry_of(
                                                                     given, "species");
    if (!volume || !species || species->value->kind != YamlNode::Kind::sequence)
      fail(item.value->place, "{}: got {}, expected {{volume: 2, species: [A, B]}}", path,
           volume ? "no list of species" : "no volume");
    const Id size = constant(*volume->value, path + ": volume");
    if (!(problem_.graph[size].value > 0))
      fail(volume->value->place, "{}: volume: got {:.6Lg}, expected a positive number", path,
           problem_.graph[size].value);
    constants_.names[item.key] = size;
    compartments_.push_back({item.key, size, species->value});
  }
}

void Reader::place_species(const Scope& scope) {
  compartment_of_.assign(problem_.states.size(), nowhere);
  for (std::size_t k = 0; k < compartments_.size(); ++k)
    for (const auto& each : compartments_[k].species->items) {
      const std::string path = "compartments: " + compartments_[k].name;
      const Id id = expression({path, each->place, each.get()}, "", scope);
      const Node& node = problem_.graph[id];
      if (node.op != Op::state)
        fail(each->place, "{}: no state; got {}, expected the name of one", path,
             shown(each->text));
      if (compartment_of_[node.index] != nowhere)
        fail(each->place, "{}: a species twice; got {}, which is in {} too, expected it once", path,
             each->text, compartments_[compartment_of_[node.index]].name);
      compartment_of_[node.index] = k;
    }
}

std::vector<std::size_t> Reader::compartments_of(const std::vector<Participant>& side) const {
  std::vector<std::size_t> all;
  for (const Participant& each : side)
    if (const Node& node = problem_.graph[each.species]; node.op == Op::state)
      if (const std::size_t in = compartment_of_[node.index]; std::ranges::count(all, in) == 0)
        all.push_back(in);
  return all;
}

void Reader::find_compartment(Reaction& reaction, const Item* given) const {
  const std::vector<std::size_t> left = compartments_of(reaction.left),
                                 right = compartments_of(reaction.right),
                                 own = left.empty() ? right : left;
  if (given) {
    const std::string name = scalar(*given->value, "in");
    const auto found = std::ranges::find(compartments_, name, &Compartment::name);
    if (found == compartments_.end()) {
      std::vector<std::string> names;
      for (const Compartment& each : compartments_) names.push_back(each.name);
      fail(given->value->place, "reactions: in: no compartment; got {}, expected {}", shown(name),
           names.empty() ? "none: there are no compartments" : one_of(names, name));
    }
    reaction.in = static_cast<std::size_t>(found - compartments_.begin());
  } else if (own.size() > 1) {
    fail(reaction.place,
         "reactions: {}: species of several compartments react; got no compartment of which the "
         "volume counts, expected {{rate: ..., in: NAME}}",
         shown(reaction.text));
  } else if (!own.empty()) {
    reaction.in = own.front();
  }
  const auto elsewhere = [&](std::size_t in) { return in != reaction.in; };
  reaction.between = std::ranges::any_of(left, elsewhere) || std::ranges::any_of(right, elsewhere);
  if (reaction.between && (reaction.in == nowhere || std::ranges::count(left, nowhere) > 0 ||
                           std::ranges::count(right, nowhere) > 0))
    fail(reaction.place,
         "reactions: {}: a species in no compartment; got one beside a species of a compartment, "
         "expected all in compartments",
         shown(reaction.text));
}

Id Reader::mass_action(Id constant, const std::vector<Participant>& side) {
  Graph& graph = problem_.graph;
  for (const Participant& each : side)
    constant =
        graph.make(Op::multiply, constant, graph.make(Op::power, each.species, each.coefficient));
  return constant;
}

void Reader::read_rate(Reaction& reaction, const YamlNode& value, const Scope& scope) {
  const std::string path = "reactions: " + reaction.text;
  const Item* in = nullptr;
  std::vector<Item> given;
  if (value.kind == YamlNode::Kind::mapping) {
    constexpr std::string_view keys[] = {"rate", "in"};
    given = items(value, path, keys);
    const Item* const rate = input::entry_of(given, "rate");
    if (!rate) fail(value.place, "{}: got no rate, expected {{rate: ...}}", shown(path));
    reaction.rate = expression(*rate, path, scope);
    in = input::entry_of(given, "in");
  } else if (value.kind == YamlNode::Kind::sequence) {
    if (!reaction.is_reversible || value.items.size() != 2)
      fail(value.place, "{}: got {} constants, expected {}", shown(path), value.items.size(),
           reaction.is_reversible ? "two: [forward, backward]" : "one");
    Id rates[2];
    for (const std::size_t k : {0U, 1U})
      rates[k] =
          mass_action(expression({path, value.items[k]->place, value.items[k].get()}, "", scope),
                      k == 0 ? reaction.left : reaction.right);
    reaction.rate = problem_.graph.make(Op::subtract, rates[0], rates[1]);
  } else {
    if (reaction.is_reversible)
      fail(value.place, "{}: got one constant, expected two: [forward, backward]", shown(path));
    reaction.rate = mass_action(expression({path, value.place, &value}, "", scope), reaction.left);
  }
  find_compartment(reaction, in);
}

std::vector<Reaction> Reader::reactions(const Scope& scope) {
  const YamlNode& list = *section("reactions")->value;
  if (list.kind != YamlNode::Kind::sequence)
    fail(list.place, "reactions: got {}, expected a list: [A + 2 B -> C: k1, ...]",
         list.kind_name());
  std::vector<Reaction> all;
  for (const auto& each : list.items) {
    const bool is_pair = each->kind == YamlNode::Kind::mapping && each->items.size() == 2;
    if (!is_pair)
      fail(each->place, "reactions: got {}, expected a reaction and its rate: `A + B -> C: k1`",
           each->kind == YamlNode::Kind::scalar ? shown(each->text) : each->kind_name());
    const Item item = items(*each, "reactions").front();
    Reaction reaction;
    try {
      reaction = read_reaction(item.key, scope, constants_, problem_.graph);
    } catch (const ExpressionError& error) {
      const YamlNode& key = *each->items.front();
      fail(place_in(key, item.key, error.at()), "reactions: {}: {}", shown(item.key), error.what());
    }
    reaction.text = item.key;
    reaction.place = item.key_place;
    read_rate(reaction, *item.value, scope);
    problem_.equations_text +=
        fmt::format("{}{}", problem_.equations_text.empty() ? "" : ", ", reaction.text);
    all.push_back(std::move(reaction));
  }
  return all;
}

void Reader::require_finite_rates(const std::vector<Reaction>& reactions) const {
  std::vector<Id> rates;
  for (const Reaction& each : reactions) rates.push_back(each.rate);
  const Evaluator<long double> evaluate(problem_.graph, rates);
  std::vector<long double> values(rates.size());
  evaluate(problem_.t0, problem_.y0.data(), values.data());
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]))
      fail(reactions[k].place,
           "reactions: {}: a rate that is not finite at the start; got {}, expected a finite "
           "number (a division by a species that is 0?)",
           shown(reactions[k].text), static_cast<double>(values[k]));
}

void Reader::add_reaction(const Reaction& reaction, Balance& balance) {
  Graph& graph = problem_.graph;
  std::map<std::uint32_t, Id> net;  // numbers, or constants with names that sweeps change
  for (const auto* side : {&reaction.left, &reaction.right})
    for (const Participant& each : *side) {
      if (graph[each.species].op != Op::state) continue;
      Id& number = net.try_emplace(graph[each.species].index, graph.constant(0)).first->second;
      number =
          graph.make(side == &reaction.left ? Op::subtract : Op::add, number, each.coefficient);
    }
  Weights amounts;
  for (const auto& [state, number] : net) {
    if (balance.place[state].line == 0) balance.place[state] = reaction.place;
    if (graph.is(number, 0)) continue;
    const long double value = graph[number].value;
    const bool is_loss = graph.is_number(number) && value < 0;
    Id term = graph.make(Op::multiply, is_loss ? graph.constant(-value) : number, reaction.rate);
    if (reaction.between && compartment_of_[state] != reaction.in)
      term =
          graph.make(Op::divide, graph.make(Op::multiply, term, compartments_[reaction.in].volume),
                     compartments_[compartment_of_[state]].volume);
    (is_loss ? balance.losses : balance.gains)[state].push_back(term);
    amounts[state] = value;
    if (!graph.is_number(number)) balance.made.push_back({{state, 1}});
  }
  balance.made.push_back(std::move(amounts));
}

void Reader::read_reactions(const Scope& scope) {
  place_species(scope);
  const std::vector<Reaction> all = reactions(scope);
  require_finite_rates(all);
  const std::size_t n = problem_.states.size();
  Balance balance{.gains = std::vector<std::vector<Id>>(n),
                  .losses = std::vector<std::vector<Id>>(n),
                  .place = std::vector<Place>(n, Place{0, 0}),
                  .made = {}};
  for (std::uint32_t k = 0; k < n; ++k)
    if (problem_.equations[k] != no_node) {
      balance.gains[k].push_back(problem_.equations[k]);
      balance.made.push_back({{k, 1}});
    }
  for (const Reaction& reaction : all) add_reaction(reaction, balance);
  for (std::size_t k = 0; k < n; ++k) {
    if (balance.place[k].line == 0) continue;
    if (problem_.equations[k] == no_node) problem_.places[k] = balance.place[k];
    problem_.equations[k] =
        problem_.graph.make(Op::subtract, sum_of(problem_.graph, balance.gains[k]),
                            sum_of(problem_.graph, balance.losses[k]));
  }
  if (n <= most_summed) add_conserved_sums(balance.made);
}

void Reader::add_conserved_sums(const std::vector<Weights>& made) {
  Graph& graph = problem_.graph;
  std::size_t number = 0;
  for (const Weights& sum :
       conserved_sums(static_cast<std::uint32_t>(problem_.states.size()), made)) {
    std::string name = "sum_of";
    std::vector<Id> terms;
    for (const auto& [state, weight] : sum) {
      Id term = graph.make(Op::multiply, graph.constant(weight), graph.state(state));
      if (compartment_of_[state] != nowhere)
        term = graph.make(Op::multiply, compartments_[compartment_of_[state]].volume, term);
      terms.push_back(term);
      name += '_' + (weight == 1 ? "" : fmt::format("{:.6Lg}", weight)) + problem_.states[state];
    }
    ++number;
    constexpr std::size_t longest = 40;
    if (name.size() > longest || !fault_of_name(name).empty()) name = fmt::format("sum_{}", number);
    problem_.invariants.push_back(
        {name, sum_of(graph, terms), section("reactions")->key_place, true});
  }
}

}  // namespace odeum::formula::reading
