// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "odeum/formula/parser.hpp"

namespace odeum::formula {
namespace {

/// The derivative of an operation by an argument as in its row of operations.cpp: `roots` of a
/// graph whose states 0, 1 and 2 are a, b and w; no_node where there is none.
struct Rules {
  Graph graph;
  std::vector<std::array<Id, 2>> of;  ///< by operation and argument

  Rules() {
    Scope scope;
    scope.names = {{"a", graph.state(0)}, {"b", graph.state(1)}, {"w", graph.state(2)}};
    for (std::size_t op = leaves; op <= static_cast<std::size_t>(Op::choose); ++op) {
      std::array<Id, 2> roots{no_node, no_node};
      for (std::size_t k = 0; k < 2; ++k)
        if (const char* const text = meaning_of(static_cast<Op>(op)).partials[k])
          roots[k] = parse_expression(text, scope, graph);
      of.push_back(roots);
    }
  }
  /// The rule with a, b and w put in.
  Id in(Graph& target, Id root, const std::array<Id, 3>& given) const {
    const Node& node = graph[root];
    if (node.op == Op::state) return given[node.index];
    if (node.op == Op::constant) return target.constant(node.value);
    std::array<Id, 3> of_node{no_node, no_node, no_node};
    for (std::size_t k = 0; k < arity(node.op); ++k) of_node[k] = in(target, node.of[k], given);
    return target.make(node.op, of_node[0], of_node[1], of_node[2]);
  }
};

/// A power's derivative by its base with a constant exponent, of which products and roots are
/// already made: w / a would fail at a = 0.
Id partial_at(Graph& g, Id id, std::size_t argument) {
  const Node n = g[id];
  if (n.op != Op::power || argument != 0 || !g.is_constant(n.of[1])) return g.partial(id, argument);
  const Id less = g.make(Op::subtract, n.of[1], g.constant(1));
  return g.make(Op::multiply, n.of[1], g.make(Op::power, n.of[0], less));
}

/// d += outer * inner for each entry of `inner`; both in ascending order of `by`.
std::vector<Entry> plus_multiple(Graph& g, const std::vector<Entry>& d, Id outer,
                                 const std::vector<Entry>& inner) {
  std::vector<Entry> sum;
  sum.reserve(d.size() + inner.size());
  auto at = d.begin();
  for (const Entry& entry : inner) {
    while (at != d.end() && at->by < entry.by) sum.push_back(*at++);
    Id value = g.make(Op::multiply, outer, entry.value);
    if (at != d.end() && at->by == entry.by) value = g.make(Op::add, at++->value, value);
    if (!g.is(value, 0)) sum.push_back({entry.by, value});
  }
  sum.insert(sum.end(), at, d.end());
  return sum;
}

}  // namespace

Id Graph::partial(Id node, std::size_t argument) {
  static const Rules rules;
  const Node n = nodes_[node];
  if (is_leaf(n.op)) return no_node;
  if (n.op == Op::choose)
    return argument == 0 ? no_node
                         : make(Op::choose, n.of[0], constant(argument == 1 ? 1 : 0),
                                constant(argument == 2 ? 1 : 0));
  const Id rule = rules.of[static_cast<std::size_t>(n.op) - leaves][argument];
  return rule == no_node ? no_node : rules.in(*this, rule, {n.of[0], n.of[1], node});
}

std::vector<std::vector<Entry>> gradients(Graph& graph, const std::vector<Id>& roots,
                                          std::uint32_t states, std::size_t most) {
  const std::vector<Id> nodes = graph.needed(roots);
  std::unordered_map<Id, std::vector<Entry>> of;
  std::size_t total = 0;
  for (const Id id : nodes) {
    const Node node = graph[id];
    std::vector<Entry> d;
    if (node.op == Op::state) {
      d.push_back({node.index, graph.constant(1)});
    } else if (node.op == Op::time) {
      d.push_back({states, graph.constant(1)});
    } else {
      for (std::size_t k = 0; k < arity(node.op); ++k) {
        const std::vector<Entry>& inner = of.at(node.of[k]);
        if (inner.empty()) continue;
        if (const Id outer = partial_at(graph, id, k); outer != no_node)
          d = plus_multiple(graph, d, outer, inner);
      }
    }
    total += d.size();
    if (total > most)
      throw std::length_error(fmt::format(
          "the derivatives of the equations: got more than {}, those of all parts of an "
          "expression counted; expected at most that: sums over fewer states",
          most));
    of.emplace(id, std::move(d));
  }
  std::vector<std::vector<Entry>> result;
  for (const Id root : roots) result.push_back(of.at(root));
  return result;
}

}  // namespace odeum::formula
