// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/table.hpp"

#include <algorithm>
#include <array>

namespace odeum::formula {
namespace {

using Real = long double;

/// The second derivatives of the natural cubic spline at its points.
std::vector<Real> second_derivatives(const Table& table) {
  const std::size_t n = table.x.size();
  std::vector<Real> diagonal(n, 1), right(n, 0), above(n, 0);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const Real before = table.x[k] - table.x[k - 1], after = table.x[k + 1] - table.x[k];
    const Real jump =
        (table.y[k + 1] - table.y[k]) / after - (table.y[k] - table.y[k - 1]) / before;
    // Thomas' algorithm.
    diagonal[k] = 2 * (before + after) - before * above[k - 1];
    above[k] = after / diagonal[k];
    right[k] = (6 * jump - before * right[k - 1]) / diagonal[k];
  }
  for (std::size_t k = n - 1; k-- > 1;) right[k] -= above[k] * right[k + 1];
  return right;
}

/// The coefficients of the powers of x - x[k], from the point k to the next.
std::vector<std::array<Real, 4>> pieces(const Table& table) {
  const std::size_t n = table.x.size();
  std::vector<std::array<Real, 4>> all(n - 1);
  const std::vector<Real> m =
      table.between == Table::Between::cubic ? second_derivatives(table) : std::vector<Real>(n, 0);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const Real h = table.x[k + 1] - table.x[k], slope = (table.y[k + 1] - table.y[k]) / h;
    all[k] = {table.y[k], 0, 0, 0};
    if (table.between == Table::Between::constant) continue;
    all[k][1] = slope - h * (2 * m[k] + m[k + 1]) / 6;
    all[k][2] = m[k] / 2;
    all[k][3] = (m[k + 1] - m[k]) / (6 * h);
  }
  return all;
}

}  // namespace

Id value_at(Graph& graph, const Table& table, Id at) {
  std::vector<std::array<Real, 4>> all = pieces(table);
  std::vector<Real> from(table.x.begin(), table.x.end() - 1);
  std::vector<Real> bounds(table.x.begin() + 1, table.x.end() - 1);  // between pieces
  if (table.between == Table::Between::constant) {
    // The last value begins at the last point.
    bounds.push_back(table.x.back());
    from.push_back(table.x.back());
    all.push_back({table.y.back(), 0, 0, 0});
  } else if (table.outside == Table::Outside::hold) {
    bounds.push_back(table.x.back());
    from.push_back(table.x.back());
    all.push_back({table.y.back(), 0, 0, 0});
    bounds.insert(bounds.begin(), table.x.front());
    from.insert(from.begin(), table.x.front());
    all.insert(all.begin(), {table.y.front(), 0, 0, 0});
  }
  std::vector<Id> below;
  for (const Real bound : bounds) below.push_back(graph.make(Op::less, at, graph.constant(bound)));
  // The piece is found by bisection, and its numbers chosen: nothing is computed that is not used.
  const auto chosen = [&](const auto& self, const auto& number, std::size_t first,
                          std::size_t last) -> Id {
    if (first == last) return graph.constant(number(first));
    const std::size_t middle = first + (last - first) / 2;
    const Id low = self(self, number, first, middle), high = self(self, number, middle + 1, last);
    return low == high ? low : graph.make(Op::choose, below[middle], low, high);
  };
  const auto of_piece = [&](const auto& number) {
    return chosen(chosen, number, 0, all.size() - 1);
  };
  const Id x = graph.make(Op::subtract, at, of_piece([&](std::size_t k) { return from[k]; }));
  Id value = graph.constant(0);
  for (std::size_t power = 4; power-- > 0;)
    value = graph.make(Op::add, of_piece([&](std::size_t k) { return all[k][power]; }),
                       graph.make(Op::multiply, value, x));
  if (table.outside != Table::Outside::error) return value;
  const auto beyond = [&](Id a, Id b) {  // the root of b - a has no value where a > b
    value = graph.make(Op::choose, graph.make(Op::less_equal, a, b), value,
                       graph.make(Op::sqrt, graph.make(Op::subtract, b, a)));
  };
  beyond(graph.constant(table.x.front()), at);
  beyond(at, graph.constant(table.x.back()));
  return value;
}

}  // namespace odeum::formula
