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

/// The derivative of a node by its argument, where that is known at places at which the rule of the
/// table is 0/0.
Id partial_at(Graph& g, Id id, std::size_t argument) {
  const Node n = g[id];
  if (n.op == Op::abs) return g.make(Op::side, n.of[0]);
  if (n.op != Op::power || argument != 0) return g.partial(id, argument);
  const Id less = g.make(Op::subtract, n.of[1], g.constant(1));
  return g.make(Op::multiply, n.of[1], g.make(Op::power, n.of[0], less));
}

/// d += outer * inner for each entry of `inner`; both in ascending order of `by`. `product` makes
/// the products.
template <class Product>
std::vector<Entry> plus_multiple(Graph& g, const std::vector<Entry>& d, Id outer,
                                 const std::vector<Entry>& inner, const Product& product) {
  std::vector<Entry> sum;
  sum.reserve(d.size() + inner.size());
  auto at = d.begin();
  for (const Entry& entry : inner) {
    while (at != d.end() && at->by < entry.by) sum.push_back(*at++);
    Id value = product(outer, entry.value);
    if (at != d.end() && at->by == entry.by) value = g.make(Op::add, at++->value, value);
    if (!g.is(value, 0)) sum.push_back({entry.by, value});
  }
  sum.insert(sum.end(), at, d.end());
  return sum;
}

/// Entry by entry, the one that a condition selects.
std::vector<Entry> selected(Graph& g, Id condition, const std::vector<Entry>& yes,
                            const std::vector<Entry>& no) {
  std::vector<Entry> d;
  for (auto a = yes.begin(), b = no.begin(); a != yes.end() || b != no.end();) {
    const bool has_a = a != yes.end() && (b == no.end() || a->by <= b->by),
               has_b = b != no.end() && (a == yes.end() || b->by <= a->by);
    const std::uint32_t by = has_a ? a->by : b->by;
    const Id zero = g.constant(0), first = has_a ? a++->value : zero,
             second = has_b ? b++->value : zero;
    d.push_back({by, g.make(Op::choose, condition, first, second)});
  }
  return d;
}

/// The derivatives of nodes, in the order of their ids.
class Gradients {
 public:
  Gradients(Graph& graph, std::uint32_t states) : graph_(graph), states_(states) {}

  const std::vector<Entry>& of(Id id) const { return of_.at(id); }
  /// Adds the derivatives of a node; those of its arguments are known.
  const std::vector<Entry>& add(Id id) {
    return of_.emplace(id, made(id, graph_[id])).first->second;
  }

 private:
  auto product() {
    return [this](Id outer, Id inner) { return graph_.make(Op::multiply, outer, inner); };
  }
  /// 0 where the inner derivative is 0 since a condition selects it, also where the outer one is
  /// infinite: that of sqrt(max(x, 0)) below 0.
  auto product_with_zero() {
    return [this](Id outer, Id inner) {
      const Id product = graph_.make(Op::multiply, outer, inner), zero = graph_.constant(0);
      if (!has_choice(inner)) return product;
      return graph_.make(Op::choose, graph_.make(Op::equal, inner, zero), zero, product);
    };
  }

  std::vector<Entry> made(Id id, const Node node) {
    const auto condition = [&](std::size_t a, std::size_t b) {
      return graph_.make(Op::less, node.of[a], node.of[b]);
    };
    switch (node.op) {
      case Op::state:
        return {{node.index, graph_.constant(1)}};
      case Op::time:
        return {{states_, graph_.constant(1)}};
      case Op::choose:
        return selected(graph_, node.of[0], of(node.of[1]), of(node.of[2]));
      case Op::min:
        return selected(graph_, condition(1, 0), of(node.of[1]), of(node.of[0]));
      case Op::max:
        return selected(graph_, condition(0, 1), of(node.of[1]), of(node.of[0]));
      default:
        return by_chain(id, node);
    }
  }
  std::vector<Entry> by_chain(Id id, const Node& node) {
    // A power with a half exponent is a product with a root, whose derivative is infinite at 0.
    if (const auto [base, exponent] = graph_.half_power(id); base != no_node)
      return plus_multiple(graph_, {},
                           graph_.make(Op::multiply, graph_.constant(exponent),
                                       graph_.make(Op::power, base, graph_.constant(exponent - 1))),
                           of(base), product());
    const bool is_steep = node.op == Op::sqrt || node.op == Op::power || node.op == Op::asin ||
                          node.op == Op::acos || node.op == Op::hypot;
    std::vector<Entry> d;
    for (std::size_t k = 0; k < arity(node.op); ++k) {
      const std::vector<Entry>& inner = of(node.of[k]);
      if (inner.empty()) continue;
      if (const Id outer = partial_at(graph_, id, k); outer != no_node)
        d = is_steep ? plus_multiple(graph_, d, outer, inner, product_with_zero())
                     : plus_multiple(graph_, d, outer, inner, product());
    }
    return d;
  }
  bool has_choice(Id id) {
    for (auto next = static_cast<Id>(has_choice_.size()); next <= id; ++next) {
      const Node& node = graph_[next];
      bool has = node.op == Op::choose;
      for (const Id argument : node.of)
        has = has || (argument != no_node && !is_leaf(node.op) && has_choice_[argument]);
      has_choice_.push_back(has);
    }
    return has_choice_[id];
  }

  Graph& graph_;
  std::uint32_t states_;
  std::unordered_map<Id, std::vector<Entry>> of_;
  std::vector<bool> has_choice_;
};

}  // namespace

Id Graph::partial(Id node, std::size_t argument) {
  static const Rules rules;
  const Node n = nodes_[node];
  if (is_leaf(n.op)) return no_node;
  const Id rule = rules.of[static_cast<std::size_t>(n.op) - leaves][argument];
  return rule == no_node ? no_node : rules.in(*this, rule, {n.of[0], n.of[1], node});
}

std::vector<std::vector<Entry>> gradients(Graph& graph, const std::vector<Id>& roots,
                                          std::uint32_t states, std::size_t most) {
  Gradients known(graph, states);
  std::size_t total = 0;
  for (const Id id : graph.needed(roots)) {
    total += known.add(id).size();
    if (total > most)
      throw std::length_error(fmt::format(
          "the derivatives of the equations: got more than {}, those of all parts of an "
          "expression counted; expected at most that: sums over fewer states",
          most));
  }
  std::vector<std::vector<Entry>> result;
  for (const Id root : roots) result.push_back(known.of(root));
  return result;
}

}  // namespace odeum::formula
