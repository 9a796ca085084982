// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "odeum/formula/consistent_start.hpp"
#include "odeum/formula/evaluator.hpp"

namespace odeum::formula {
namespace {

using Real = long double;

/// What decides between the alternatives of a node: its zeros are where that changes.
Id switching_function(Graph& graph, Id id) {
  const Node node = graph[id];
  switch (node.op) {
    case Op::abs:
    case Op::side:
    case Op::sign:
      return node.of[0];
    case Op::less:
    case Op::less_equal:
    case Op::equal:
    case Op::min:
    case Op::max:
      return graph.make(Op::subtract, node.of[0], node.of[1]);
    default:
      return no_node;
  }
}

class JumpSearch {
 public:
  JumpSearch(Graph& graph, Id expression, Id decides)
      : graph_(graph),
        expression_(expression),
        decides_(decides),
        both_(graph, {expression, decides}) {}

  /// Beside a zero that is found by one state from y on.
  bool is_found_near(Real t, std::vector<Real> y) const {
    std::vector<std::size_t> states;
    for (const Id id : graph_.needed({decides_}))
      if (graph_[id].op == Op::state) states.push_back(graph_[id].index);
    if (states.empty()) return false;
    const Linearised at = linearise(graph_, {decides_}, t, y, states);
    std::size_t by = 0;
    const auto weight = [&](std::size_t k) {
      return std::abs(at.slopes[0][k]) * (1e-6L + std::abs(y[states[k]]));
    };
    for (std::size_t k = 1; k < states.size(); ++k)
      if (weight(k) > weight(by)) by = k;
    if (!find_roots(graph_, {decides_}, t, y, {states[by]})) return false;
    const Real apart = apart_ * std::max(std::abs(y[states[by]]), 1e-6L);
    std::vector<Real> before = y, after = y;
    before[states[by]] -= apart;
    after[states[by]] += apart;
    return differ(t, before, t, after);
  }
  /// Where the time alone decides, between t and `end`.
  bool is_found_between(Real t, Real end, const std::vector<Real>& y) const {
    constexpr int parts = 256;
    const auto decide = [&](Real time) { return values(time, y)[1]; };
    for (int k = 0; k < parts; ++k) {
      Real low = t + (end - t) * k / parts, high = t + (end - t) * (k + 1) / parts;
      const bool negative = decide(low) < 0;
      if ((decide(high) < 0) == negative) continue;
      for (int halving = 0; halving < 60; ++halving) {
        const Real middle = (low + high) / 2;
        ((decide(middle) < 0) == negative ? low : high) = middle;
      }
      const Real apart = apart_ * std::max(std::abs(low), end - t);
      if (differ(low - apart, y, high + apart, y)) return true;
    }
    return false;
  }

 private:
  std::array<Real, 2> values(Real t, const std::vector<Real>& y) const {
    std::array<Real, 2> found{};
    both_(t, y.data(), found.data());
    return found;
  }
  bool differ(Real t0, const std::vector<Real>& y0, Real t1, const std::vector<Real>& y1) const {
    const Real a = values(t0, y0)[0], b = values(t1, y1)[0];
    const Real size =
        std::max({std::abs(a), std::abs(b), linearise(graph_, {expression_}, t0, y0, {}).sizes[0]});
    return std::abs(a - b) > 1e-6L * size;
  }

  static constexpr Real apart_ = 1e-11L;
  Graph& graph_;
  Id expression_, decides_;
  Evaluator<Real> both_;
};

}  // namespace

Id jump_of(Graph& graph, Id expression, Real t, Real end, const std::vector<Real>& y) {
  constexpr std::size_t most = 100;
  std::set<Id> functions;
  for (const Id id : graph.needed({expression}))
    if (const Id function = switching_function(graph, id);
        function != no_node && !graph.is_constant(function) && functions.size() < most)
      functions.insert(function);
  for (const Id function : functions) {
    const JumpSearch search(graph, expression, function);
    if (search.is_found_between(t, end, y)) return function;
    for (const Real moved : {0.L, 1e-3L, 0.1L, 1.L}) {
      std::vector<Real> at = y;
      for (Real& each : at) each += moved * std::max(std::abs(each), moved);
      if (search.is_found_near(t, at)) return function;
    }
  }
  return no_node;
}

}  // namespace odeum::formula
