// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "odeum/formula/reduction.hpp"

namespace odeum::formula {

std::set<std::uint32_t> nonlinear_rates(Graph& graph, const std::vector<Id>& residuals) {
  std::set<std::uint32_t> found;
  for (const auto& row : gradients(graph, residuals, 2 * first_rate))
    for (const Entry& entry : row) {
      if (entry.by < first_rate || entry.by == 2 * first_rate) continue;
      for (const Id id : graph.needed({entry.value}))
        if (graph[id].op == Op::state && graph[id].index >= first_rate)
          found.insert(entry.by - first_rate);
    }
  return found;
}

std::vector<Id> with_states_replaced(Graph& graph, const std::vector<Id>& roots,
                                     const std::map<std::uint32_t, Id>& by) {
  std::map<Id, Id> made;
  for (const Id id : graph.needed(roots)) {
    const Node node = graph[id];
    Id now = id;
    if (node.op == Op::state) {
      if (const auto found = by.find(node.index); found != by.end()) now = found->second;
    } else if (!is_leaf(node.op)) {
      std::array<Id, 3> of = node.of;
      for (Id& each : of)
        if (each != no_node) each = made.at(each);
      if (of != node.of) now = graph.make(node.op, of[0], of[1], of[2]);
    }
    made[id] = now;
  }
  std::vector<Id> replaced;
  for (const Id root : roots) replaced.push_back(made.at(root));
  return replaced;
}

std::vector<int> indices_of(const Reduction& reduction, const Graph& graph) {
  const std::size_t n = reduction.by.size();
  std::vector<std::vector<std::size_t>> states;  // by constraint
  std::vector<bool> algebraic(n);
  for (const Constraint& constraint : reduction.constraints) {
    auto& all = states.emplace_back();
    for (const Id id : graph.needed({constraint.value}))
      if (graph[id].op == Op::state) all.push_back(graph[id].index);
    for (std::size_t k = 0; k < n; ++k)
      algebraic[k] = algebraic[k] || reduction.by[k] == constraint.own;
  }
  std::vector<int> first(n, highest_index), last(n, 0);
  for (std::size_t c = 0; c < states.size(); ++c) {
    const Constraint& constraint = reduction.constraints[c];
    const bool leads_on = std::ranges::any_of(reduction.constraints, [&](const Constraint& other) {
      return other.own == constraint.own && other.level > 0;
    });
    for (const std::size_t k : states[c]) {
      if (leads_on) first[k] = std::min(first[k], constraint.level);
      last[k] = std::max(last[k], constraint.level);
    }
  }
  std::vector<int> indices(n, 1);
  for (std::size_t k = 0; k < n; ++k)
    if (algebraic[k] || first[k] < highest_index)
      indices[k] = 1 + (algebraic[k] ? last[k] : first[k]);
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::vector<std::size_t>& all : states) {
      int highest = 1;
      for (const std::size_t k : all)
        if (algebraic[k]) highest = std::max(highest, indices[k]);
      for (const std::size_t k : all) {
        if (!algebraic[k] || indices[k] == highest) continue;
        indices[k] = highest;
        changed = true;
      }
    }
  }
  return indices;
}

}  // namespace odeum::formula
