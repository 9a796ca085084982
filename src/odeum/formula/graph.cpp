// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace odeum::formula {

std::size_t Graph::Hash::operator()(const Key& key) const {
  std::uint64_t h = 0x9e3779b97f4a7c15U;
  for (const std::uint64_t word : key.words) h = (h ^ word) * 0xff51afd7ed558ccdU ^ (h >> 29);
  return static_cast<std::size_t>(h ^ (h >> 32));
}

Graph::Key Graph::key_of(const Node& node) {
  Key key{};
  key.words[0] = static_cast<std::uint64_t>(node.op) | std::uint64_t{node.of[0]} << 32;
  key.words[1] = node.of[1] | std::uint64_t{node.of[2]} << 32;
  if (node.op == Op::constant && node.index == 0) {
    // A number to its last bit: as a double and what that leaves.
    const auto head = static_cast<double>(node.value);
    const auto tail = static_cast<double>(node.value - static_cast<long double>(head));
    std::memcpy(&key.words[2], &head, sizeof head);
    std::memcpy(&key.words[3], &tail, sizeof tail);
  } else {
    key.words[2] = node.index;
    key.words[3] = node.op == Op::constant ? 1 : 0;
  }
  return key;
}

Id Graph::intern(Node node) {
  const auto [at, added] = known_.try_emplace(key_of(node), static_cast<Id>(nodes_.size()));
  if (added) nodes_.push_back(node);
  return at->second;
}

Id Graph::constant(long double value) {
  return intern({.op = Op::constant, .value = value + 0.0L});
}

Id Graph::named(long double value, const std::string& name) {
  definitions_.push_back({.name = name, .id = static_cast<Id>(nodes_.size())});
  return intern({.op = Op::constant,
                 .index = static_cast<std::uint32_t>(definitions_.size()),
                 .value = value});
}

Id Graph::define(const Node& node, long double value) {
  const auto [at, added] = known_.try_emplace(key_of(node), static_cast<Id>(nodes_.size()));
  if (!added) return at->second;
  definitions_.push_back({.name = "c" + std::to_string(nodes_.size()) + "_",
                          .id = static_cast<Id>(nodes_.size()),
                          .op = node.op,
                          .of = node.of});
  nodes_.push_back({.op = Op::constant,
                    .index = static_cast<std::uint32_t>(definitions_.size()),
                    .value = value});
  return at->second;
}

long double Graph::folded(Op op, Id a, Id b, Id c) const {
  const std::size_t n = arity(op);
  return apply(op, nodes_[a].value, n < 2 ? 0 : nodes_[b].value, n < 3 ? 0 : nodes_[c].value);
}

Id Graph::make(Op op, Id a, Id b, Id c) {
  const std::size_t n = arity(op);
  const auto all = [&](const auto& is) { return is(a) && (n < 2 || is(b)) && (n < 3 || is(c)); };
  if (all([this](Id id) { return is_number(id); })) return constant(folded(op, a, b, c));
  if (op == Op::choose) {
    if (is_number(a)) return nodes_[a].value != 0 ? b : c;
    if (b == c) return b;
  }
  if (const Id simple = simplified(op, a, b); simple != no_node) return simple;
  // Equal in any order, to the last bit.
  if ((op == Op::add || op == Op::multiply || op == Op::equal) && b < a) std::swap(a, b);
  const Node node{.op = op, .of = {a, b, c}};
  if (all([this](Id id) { return is_constant(id); })) return define(node, folded(op, a, b, c));
  return intern(node);
}

Id Graph::simplified(Op op, Id a, Id b) {
  switch (op) {
    case Op::add:
    case Op::subtract:
      return simplified_sum(op, a, b);
    case Op::multiply:
    case Op::divide:
      return simplified_product(op, a, b);
    case Op::negate:
      if (nodes_[a].op == Op::negate) return nodes_[a].of[0];
      if (nodes_[a].op == Op::subtract) return make(Op::subtract, nodes_[a].of[1], nodes_[a].of[0]);
      return no_node;
    case Op::power:
      return simplified_power(a, b);
    case Op::min:
    case Op::max:
      return a == b ? a : no_node;
    default:
      return no_node;
  }
}

Id Graph::simplified_sum(Op op, Id a, Id b) {
  const bool plus = op == Op::add;
  if (is(b, 0)) return a;
  if (is(a, 0)) return plus ? b : make(Op::negate, b);
  if (a == b) return plus ? make(Op::multiply, constant(2), a) : constant(0);
  if (nodes_[b].op == Op::negate) return make(plus ? Op::subtract : Op::add, a, nodes_[b].of[0]);
  if (plus && nodes_[a].op == Op::negate) return make(Op::subtract, b, nodes_[a].of[0]);
  return no_node;
}

Id Graph::simplified_product(Op op, Id a, Id b) {
  if (is(a, 0)) return a;
  if (is(b, 1)) return a;
  if (is(b, -1)) return make(Op::negate, a);
  if (op == Op::multiply) {
    if (is(b, 0)) return b;
    if (is(a, 1)) return b;
    if (is(a, -1)) return make(Op::negate, b);
  }
  const bool minus_a = nodes_[a].op == Op::negate, minus_b = nodes_[b].op == Op::negate;
  if (minus_a && minus_b) return make(op, nodes_[a].of[0], nodes_[b].of[0]);
  if (minus_a) return make(Op::negate, make(op, nodes_[a].of[0], b));
  if (minus_b) return make(Op::negate, make(op, a, nodes_[b].of[0]));
  return no_node;
}

Id Graph::whole_power(Id base, unsigned exponent) {
  if (exponent == 1) return base;
  const Id half = whole_power(base, exponent / 2);
  const Id square = make(Op::multiply, half, half);
  return exponent % 2 ? make(Op::multiply, square, base) : square;
}

Id Graph::simplified_power(Id a, Id b) {
  if (!is_number(b)) return is(a, 1) ? a : no_node;
  const long double exponent = nodes_[b].value, size = std::abs(exponent);
  if (exponent == 0) return constant(1);
  constexpr long double most = 16;
  if (size > most || 2 * size != std::floor(2 * size)) return no_node;
  const auto whole = static_cast<unsigned>(size);
  const bool half = static_cast<long double>(whole) != size;
  Id result = whole == 0 ? no_node : whole_power(a, whole);
  if (half) {
    const Id root = make(Op::sqrt, a);
    result = result == no_node ? root : make(Op::multiply, result, root);
    if (whole > 0 && !is_constant(result)) half_powers_[result] = {a, size};
  }
  return exponent > 0 ? result : make(Op::divide, constant(1), result);
}

std::vector<Id> Graph::needed(const std::vector<Id>& roots) const {
  std::vector<bool> marked(nodes_.size(), false);
  for (const Id root : roots) marked[root] = true;
  std::vector<Id> list;
  for (Id id = static_cast<Id>(nodes_.size()); id-- > 0;) {
    if (!marked[id]) continue;
    list.push_back(id);
    for (const Id argument : nodes_[id].of)
      if (argument != no_node) marked[argument] = true;
  }
  std::ranges::reverse(list);
  return list;
}

}  // namespace odeum::formula
