// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/order_conditions.hpp"

namespace odeum {

/// An additive Runge-Kutta method of S stages for y' = f_E + f_I: one tableau for each part, over
/// the same stages. The rows of both are embedded where those of one are.
template <std::size_t S>
struct AdditiveTableau {
  static constexpr std::size_t stages = S;
  Tableau<S> explicit_half, implicit_half;
  int order = 0, order_hat = 0;

  constexpr bool embedded() const { return order_hat != 0; }
  constexpr const Tableau<S>& half(std::size_t implicit) const {
    return implicit != 0 ? implicit_half : explicit_half;
  }
  /// Both parts are evaluated at the same times, so that problems that depend on t keep the order.
  constexpr bool has_common_nodes() const {
    for (std::size_t i = 0; i < S; ++i)
      if (!is_rounding(explicit_half.c(i) - implicit_half.c(i))) return false;
    return true;
  }
};

/// Calls visit(tau, residual) for each rooted tree with at most `Order` nodes and each way to give
/// its nodes to the two parts (Kennedy, Carpenter, Appl. Numer. Math. 44 (2003), section 2): the
/// conditions of Runge-Kutta methods, where a node takes weights and coefficients of its part.
/// `row` gives the weights of a half. Bit 0 of a colouring is the root, and those of the tree that
/// is grafted last stand above those of the rest.
template <int Order, std::size_t S, class Row, class Visit>
constexpr void for_each_condition(const AdditiveTableau<S>& tableau, Row&& row, Visit&& visit) {
  constexpr const auto& trees = rooted_trees<Order>;
  constexpr std::size_t colourings = std::size_t{1} << Order;
  std::array<std::array<std::array<double, S>, colourings>, trees.count> phi{};
  for (std::size_t tau = 0; tau < trees.count; ++tau) {
    const std::size_t l = trees.left[tau], r = trees.right[tau];
    const auto kept = static_cast<std::size_t>(trees.nodes[l]);
    for (std::size_t colours = 0; colours < std::size_t{1} << trees.nodes[tau]; ++colours) {
      double sum = 0;
      for (std::size_t i = 0; i < S; ++i) {
        double value = 1;
        if (tau != 0) {
          const std::size_t above = colours >> kept;
          const auto& a = tableau.half(above & 1).a;
          double graft = 0;
          for (std::size_t j = 0; j < S; ++j) graft += a[i][j] * phi[r][above][j];
          value = phi[l][colours & ((std::size_t{1} << kept) - 1)][i] * graft;
        }
        phi[tau][colours][i] = value;
        sum += row(colours & 1)[i] * value;
      }
      visit(tau, sum - 1 / trees.density[tau]);
    }
  }
}

/// The first condition up to the order stated (at most 4) that a row of both halves does not meet,
/// or that it meets all of the next order.
template <std::size_t S, class Row>
constexpr OrderFault order_fault(const AdditiveTableau<S>& tableau, Row&& row, int order) {
  FaultSearch search{.order = order};
  for_each_condition<5>(tableau, row, [&](std::size_t tau, double residual) {
    search.take(WeightRow::b, rooted_trees<5>.nodes[tau], tau, residual);
  });
  return search.result();
}

/// Nodes that differ count as a condition of order 2, that of the tree of two nodes.
template <std::size_t S>
constexpr OrderFault first_fault(const AdditiveTableau<S>& tableau) {
  if (!tableau.has_common_nodes()) return {WeightRow::b, 2, 1, 1};
  return first_fault(
      tableau, [&](std::size_t part) { return tableau.half(part).b; },
      [&](std::size_t part) { return tableau.half(part).b_hat; });
}

}  // namespace odeum
