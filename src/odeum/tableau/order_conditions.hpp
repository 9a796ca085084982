// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/tableau.hpp"

/// Order conditions by rooted trees (Hairer, Norsett, Wanner, Solving ODEs I, II.2): a method has
/// order p exactly when  sum_i b_i Phi_i(tau) = 1 / gamma(tau)  for every rooted tree tau with at
/// most p nodes. Evaluated at compile time, so that a wrong coefficient does not compile.
namespace odeum {

/// The rooted trees with at most `max_order` nodes, each as the root joined to an earlier subtree:
/// tree = butcher_product(left, right) grafts `right` onto the root of `left`. Every tree but the
/// single node has such a form; keeping `right` no later than the last one grafted onto `left`
/// lists each tree once.
template <int MaxOrder>
struct RootedTrees {
  static constexpr int max_order = MaxOrder;
  static constexpr std::array<std::size_t, 11> count_to{0, 1, 2, 4, 8, 17, 37, 85, 200, 486, 1205};
  static_assert(MaxOrder >= 1 && MaxOrder <= 10);
  static constexpr std::size_t count = count_to[MaxOrder];

  std::array<int, count> nodes{};
  std::array<std::size_t, count> left{}, right{};
  std::array<double, count> density{};  ///< gamma(tau)

  consteval RootedTrees() {
    nodes[0] = 1;
    density[0] = 1;
    // gamma(tau) = nodes(tau) * product of the densities of the root's subtrees.
    std::array<double, count> children_density{};
    children_density[0] = 1;
    std::size_t made = 1;
    for (int n = 2; n <= MaxOrder; ++n) {
      for (std::size_t l = 0; l < count_to[static_cast<std::size_t>(n) - 1]; ++l) {
        // Grafts in non-increasing order: each tree once.
        const auto size = static_cast<std::size_t>(n - nodes[l]);
        const std::size_t last = l == 0 ? made : right[l] + 1;
        for (std::size_t r = count_to[size - 1]; r < count_to[size] && r < last; ++r) {
          nodes[made] = n;
          left[made] = l;
          right[made] = r;
          children_density[made] = children_density[l] * density[r];
          density[made] = n * children_density[made];
          ++made;
        }
      }
    }
    if (made != count) throw "rooted trees miscounted";
  }
};

template <int MaxOrder>
inline constexpr RootedTrees<MaxOrder> rooted_trees{};

/// The largest violation by the row of weights among the trees with n nodes, for n = 1..Order.
/// Plain arrays and the nonzero coefficients only: the compiler counts each operation.
template <int Order, std::size_t S>
constexpr std::array<double, Order + 1> order_residuals(const Tableau<S>& tableau,
                                                        const std::array<double, S>& row) {
  constexpr auto& trees = rooted_trees<Order>;
  constexpr std::size_t grafted = RootedTrees<Order>::count_to[Order - 1];
  double value[S][S]{}, weight[S]{};
  std::size_t column[S][S]{}, entries[S]{};
  for (std::size_t i = 0; i < S; ++i) {
    weight[i] = row[i];
    for (std::size_t j = 0; j < S; ++j)
      if (tableau.a[i][j] != 0) {
        value[i][entries[i]] = tableau.a[i][j];
        column[i][entries[i]++] = j;
      }
  }
  // phi[tau][i]: the product over the root's subtrees sigma of graft[sigma][i] = sum_j a_ij
  // phi[sigma][j].
  double phi[trees.count][S]{}, graft[grafted > 0 ? grafted : 1][S]{};
  std::array<double, Order + 1> worst{};
  for (std::size_t tau = 0; tau < trees.count; ++tau) {
    const std::size_t l = trees.left[tau], r = trees.right[tau];
    double sum = 0;
    for (std::size_t i = 0; i < S; ++i) {
      phi[tau][i] = tau == 0 ? 1 : phi[l][i] * graft[r][i];
      sum += weight[i] * phi[tau][i];
    }
    if (tau < grafted)
      for (std::size_t i = 0; i < S; ++i)
        for (std::size_t e = 0; e < entries[i]; ++e)
          graft[tau][i] += value[i][e] * phi[tau][column[i][e]];
    const double violation = sum - 1 / trees.density[tau];
    double& w = worst[static_cast<std::size_t>(trees.nodes[tau])];
    w = violation > w ? violation : (-violation > w ? -violation : w);
  }
  return worst;
}

/// The largest violation of the conditions up to `Order` by the row of weights.
template <int Order, std::size_t S>
constexpr double order_residual(const Tableau<S>& tableau, const std::array<double, S>& row) {
  double worst = 0;
  for (const double w : order_residuals<Order>(tableau, row)) worst = w > worst ? w : worst;
  return worst;
}

/// The largest residual of a condition that holds, with coefficients of size one to ten rounded to
/// double: a hundred roundings. The largest of the published pairs is 1e-14 (Tsitouras 5(4), whose
/// coefficients reach 13).
inline constexpr double order_rounding = 1e-13;

/// Whether the row meets every condition up to `order` (at most 10) and fails one of the next (not
/// checked at order 10).
template <std::size_t S>
constexpr bool has_exactly_order(const Tableau<S>& tableau, const std::array<double, S>& row,
                                 int order) {
  const auto exactly = [order](const auto& residuals) {
    for (int n = 1; n <= order; ++n)
      if (!(residuals[static_cast<std::size_t>(n)] < order_rounding)) return false;
    return order == 10 || residuals[static_cast<std::size_t>(order) + 1] > order_rounding;
  };
  if (order <= 2) return exactly(order_residuals<3>(tableau, row));
  if (order <= 4) return exactly(order_residuals<5>(tableau, row));
  if (order <= 5) return exactly(order_residuals<6>(tableau, row));
  if (order <= 7) return exactly(order_residuals<8>(tableau, row));
  return order == 8 ? exactly(order_residuals<9>(tableau, row))
                    : exactly(order_residuals<10>(tableau, row));
}

/// For static_assert beside a tableau: both rows have exactly the orders stated.
template <std::size_t S>
consteval bool proven(const Tableau<S>& tableau) {
  return has_exactly_order(tableau, tableau.b, tableau.order) &&
         (!tableau.embedded() || has_exactly_order(tableau, tableau.b_hat, tableau.order_hat));
}

}  // namespace odeum
