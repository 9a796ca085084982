// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "odeum/formula/graph.hpp"

namespace odeum::formula {
namespace {

/// The derivative of an elementary function of one argument, `w` its value at u.
Id of_function(Graph& g, Op op, Id u, Id w) {
  const auto one = [&] { return g.constant(1); };
  const auto square = [&](Id x) { return g.make(Op::multiply, x, x); };
  const auto root_of_rest = [&] {  // sqrt(1 - u^2)
    return g.make(Op::sqrt, g.make(Op::subtract, one(), square(u)));
  };
  switch (op) {
    case Op::sin:
      return g.make(Op::cos, u);
    case Op::cos:
      return g.make(Op::negate, g.make(Op::sin, u));
    case Op::tan:
      return g.make(Op::add, one(), square(w));
    case Op::asin:
      return g.make(Op::divide, one(), root_of_rest());
    case Op::acos:
      return g.make(Op::divide, g.constant(-1), root_of_rest());
    case Op::atan:
      return g.make(Op::divide, one(), g.make(Op::add, one(), square(u)));
    case Op::sinh:
      return g.make(Op::cosh, u);
    case Op::cosh:
      return g.make(Op::sinh, u);
    case Op::tanh:
      return g.make(Op::subtract, one(), square(w));
    case Op::exp:
      return w;
    case Op::log:
      return g.make(Op::divide, one(), u);
    case Op::log10:
      return g.make(Op::divide, one(), g.make(Op::multiply, g.make(Op::log, g.constant(10)), u));
    case Op::sqrt:
      return g.make(Op::divide, g.constant(0.5L), w);
    case Op::abs:
      return g.make(Op::sign, u);
    default:
      return no_node;
  }
}

/// Of a function of two arguments.
Id of_pair(Graph& g, Op op, std::size_t argument, Id a, Id b, Id w) {
  const bool first = argument == 0;
  switch (op) {
    case Op::multiply:
      return first ? b : a;
    case Op::divide:
      return first ? g.make(Op::divide, g.constant(1), b)
                   : g.make(Op::negate, g.make(Op::divide, w, b));
    case Op::power:
      if (!first) return g.make(Op::multiply, w, g.make(Op::log, a));
      // With a constant exponent, of which products and roots are already made, w / a would fail at
      // a = 0.
      return g.is_constant(b) ? g.make(Op::multiply, b,
                                       g.make(Op::power, a, g.make(Op::subtract, b, g.constant(1))))
                              : g.make(Op::multiply, b, g.make(Op::divide, w, a));
    case Op::atan2: {
      const Id length = g.make(Op::add, g.make(Op::multiply, a, a), g.make(Op::multiply, b, b));
      return first ? g.make(Op::divide, b, length)
                   : g.make(Op::negate, g.make(Op::divide, a, length));
    }
    case Op::min:
    case Op::max: {
      const Id other = op == Op::min ? g.make(Op::less, b, a) : g.make(Op::less, a, b);
      return first ? g.make(Op::choose, other, g.constant(0), g.constant(1)) : other;
    }
    default:
      return no_node;
  }
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
  const Node n = nodes_[node];
  switch (n.op) {
    case Op::constant:
    case Op::time:
    case Op::state:
    case Op::less:
    case Op::less_equal:
    case Op::equal:
    case Op::sign:
      return no_node;
    case Op::add:
      return constant(1);
    case Op::subtract:
      return constant(argument == 0 ? 1 : -1);
    case Op::negate:
      return constant(-1);
    case Op::choose:
      if (argument == 0) return no_node;
      return make(Op::choose, n.of[0], constant(argument == 1 ? 1 : 0),
                  constant(argument == 2 ? 1 : 0));
    default:
      return arity(n.op) == 1 ? of_function(*this, n.op, n.of[0], node)
                              : of_pair(*this, n.op, argument, n.of[0], n.of[1], node);
  }
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
        if (const Id outer = graph.partial(id, k); outer != no_node)
          d = plus_multiple(graph, d, outer, inner);
      }
    }
    total += d.size();
    if (total > most) throw std::length_error("the derivatives of the equations are too many");
    of.emplace(id, std::move(d));
  }
  std::vector<std::vector<Entry>> result;
  for (const Id root : roots) result.push_back(of.at(root));
  return result;
}

}  // namespace odeum::formula
