// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "odeum/formula/reader.hpp"
#include "odeum/input/near_words.hpp"

namespace odeum::formula::reading {
namespace {

/// A term of a sum with its sign.
struct Term {
  bool negative;
  Id id;
  bool operator==(const Term&) const = default;
};

/// The terms of an expression in their order; those that are zero are left out.
std::vector<Term> terms_of(const Graph& graph, Id root) {
  std::vector<Term> terms, open{{false, root}};
  while (!open.empty()) {
    const Term next = open.back();
    open.pop_back();
    const Node& node = graph[next.id];
    if (node.op == Op::add || node.op == Op::subtract) {
      open.push_back({next.negative != (node.op == Op::subtract), node.of[1]});
      open.push_back({next.negative, node.of[0]});
    } else if (node.op == Op::negate) {
      open.push_back({!next.negative, node.of[0]});
    } else if (!graph.is(next.id, 0)) {
      terms.push_back(next);
    }
  }
  return terms;
}

/// A term as a number times the rest, so that -(k + 1)*x is found as a term of y - (k + 1)*x.
struct Scaled {
  long double factor;
  Id rest;
  bool operator==(const Scaled&) const = default;
};
Scaled scaled(const Graph& graph, const Term& term) {
  Scaled result{term.negative ? -1.0L : 1.0L, term.id};
  const Node& node = graph[term.id];
  if (node.op != Op::multiply) return result;
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}})
    if (graph.is_constant(node.of[k])) {
      result.factor *= graph[node.of[k]].value;
      result.rest = node.of[1 - k];
      break;
    }
  return result;
}

Id sum_of(Graph& graph, const std::vector<Term>& terms) {
  Id sum = graph.constant(0);
  for (const Term& term : terms)
    sum = graph.make(term.negative ? Op::subtract : Op::add, sum, term.id);
  return sum;
}

/// Whether each node is one of `of` or depends on one.
std::vector<bool> containing(const Graph& graph, const std::vector<Id>& of) {
  std::vector<bool> contains(graph.size(), false);
  for (const Id id : of) contains[id] = true;
  for (Id id = 0; id < graph.size(); ++id)  // arguments have smaller ids
    for (const Id argument : graph[id].of)
      if (argument != no_node && contains[argument]) contains[id] = true;
  return contains;
}

}  // namespace

/// Each name is that of a state, whose equation is implicit as a whole, or of a definition: then it
/// is the terms that contain it, in all equations.
std::vector<Id> Reader::implicit_by_name(const YamlNode& list, const Scope& scope) {
  Graph& graph = problem_.graph;
  std::vector<bool> whole(problem_.states.size(), false);
  std::vector<Id> parts(problem_.states.size(), no_node), definitions;
  for (const auto& item : list.items) {
    const std::string name = scalar(*item, "implicit");
    if (group_places_.contains(name)) {
      for (std::size_t k = 0; k < whole.size(); ++k)
        if (problem_.states[k] == name || problem_.states[k].starts_with(name + "["))
          whole[k] = true;
      continue;
    }
    const auto known = names_.find(name);
    if (known == names_.end() || known->second != "definitions") {
      std::vector<std::string> candidates;
      for (const auto& [each, kind] : names_)
        if (kind == "definitions" || kind == "states") candidates.push_back(each);
      fail(item->place, "implicit: got {}, expected a state or a definition{}", shown(name),
           near_one(name, candidates));
    }
    const Id id = scope.names.find(name)->second;
    if (graph.is_constant(id))
      fail(item->place, "implicit: a constant; got {}, expected a definition with states",
           shown(name));
    if (const std::vector<bool> with = containing(graph, {id});
        std::ranges::none_of(problem_.equations, [&](Id equation) { return with[equation]; }))
      fail(item->place, "implicit: no equation has it; got {}, expected a definition that is used",
           shown(name));
    definitions.push_back(id);
  }
  const std::vector<bool> contains = containing(graph, definitions);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (whole[k]) {
      parts[k] = problem_.equations[k];
      continue;
    }
    std::vector<Term> found;
    for (const Term& term : terms_of(graph, problem_.equations[k]))
      if (contains[term.id]) found.push_back(term);
    if (!found.empty()) parts[k] = sum_of(graph, found);
  }
  return parts;
}

void Reader::read_implicit(const Scope& scope) {
  const Item* const given = section("implicit");
  if (!given) return;
  for (const char* const other : {"mass", "residuals"})
    if (section(other))
      fail(given->key_place,
           "implicit: the equations are solved for the rates first; got it beside {0}, expected "
           "one of the two",
           other);
  const YamlNode& value = *given->value;
  const bool is_list = value.kind == YamlNode::Kind::sequence;
  if (!is_list && value.kind != YamlNode::Kind::mapping)
    fail(value.place,
         "implicit: got {}, expected terms by state, `{{x: -k*x}}`, or a list of states and "
         "definitions",
         value.kind_name());
  if (value.items.empty() && (is_list || items("implicit").empty()))
    fail(value.place, "implicit: empty; got none, expected one at least");
  std::vector<Place> places;
  const std::vector<Id> parts =
      is_list ? implicit_by_name(value, scope) : read_by_state("implicit", scope, places);
  Graph& graph = problem_.graph;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k] == problem_.equations[k]) {
      problem_.explicit_part.push_back(graph.constant(0));
      problem_.implicit_part.push_back(parts[k]);
      continue;
    }
    std::vector<Term> rest = terms_of(graph, problem_.equations[k]);
    const std::vector<Term> asked =
        parts[k] == no_node ? std::vector<Term>{} : terms_of(graph, parts[k]);
    std::vector<Term> taken;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      auto at = std::ranges::find(rest, asked[i]);
      if (at == rest.end())
        at = std::ranges::find_if(
            rest, [&](const Term& term) { return scaled(graph, term) == scaled(graph, asked[i]); });
      if (at == rest.end())
        fail(places[k],
             "implicit: {}: term {} of {} is not in its equation; got {}, expected terms as the "
             "equation has them, with their signs",
             problem_.states[k], i + 1, asked.size(),
             asked.size() == 1 ? "another expression" : "such a sum");
      taken.push_back(*at);
      rest.erase(at);
    }
    problem_.explicit_part.push_back(sum_of(graph, rest));
    problem_.implicit_part.push_back(sum_of(graph, taken));
  }
}

}  // namespace odeum::formula::reading
