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
  static constexpr std::array<std::size_t, 9> count_to{0, 1, 2, 4, 8, 17, 37, 85, 200};
  static_assert(MaxOrder >= 1 && MaxOrder <= 8);
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
      const std::size_t smaller = made;
      for (std::size_t l = 0; l < smaller; ++l) {
        for (std::size_t r = 0; r < smaller; ++r) {
          if (nodes[l] + nodes[r] != n) continue;
          if (l != 0 && r > right[l]) continue;  // grafts in non-increasing order: each tree once
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

/// The largest violation of the conditions up to `Order` by the row of weights.
template <int Order, std::size_t S>
constexpr double order_residual(const Tableau<S>& tableau, const std::array<double, S>& row) {
  constexpr auto& trees = rooted_trees<Order>;
  // phi[tau][i]: the product over the root's subtrees sigma of sum_j a_ij phi[sigma][j].
  std::array<std::array<double, S>, trees.count> phi{};
  double worst = 0;
  for (std::size_t tau = 0; tau < trees.count; ++tau) {
    double sum = 0;
    for (std::size_t i = 0; i < S; ++i) {
      phi[tau][i] = 1;
      if (tau != 0) {
        double graft = 0;
        for (std::size_t j = 0; j < S; ++j) graft += tableau.a[i][j] * phi[trees.right[tau]][j];
        phi[tau][i] = phi[trees.left[tau]][i] * graft;
      }
      sum += row[i] * phi[tau][i];
    }
    const double violation = sum - 1 / trees.density[tau];
    worst = violation > worst ? violation : (-violation > worst ? -violation : worst);
  }
  return worst;
}

/// Whether the row meets every condition up to `order` (at most 8) and fails one of the next.
/// The tolerance is a hundred roundings of coefficients of size one to ten.
template <std::size_t S>
constexpr bool has_exactly_order(const Tableau<S>& tableau, const std::array<double, S>& row,
                                 int order) {
  constexpr double rounding = 1e-13;
  const auto residual = [&](int p) {
    switch (p) {
      case 1:
        return order_residual<1>(tableau, row);
      case 2:
        return order_residual<2>(tableau, row);
      case 3:
        return order_residual<3>(tableau, row);
      case 4:
        return order_residual<4>(tableau, row);
      case 5:
        return order_residual<5>(tableau, row);
      case 6:
        return order_residual<6>(tableau, row);
      case 7:
        return order_residual<7>(tableau, row);
      default:
        return order_residual<8>(tableau, row);
    }
  };
  return residual(order) < rounding && (order == 8 || residual(order + 1) > rounding);
}

/// For static_assert beside a tableau: both rows have exactly the orders stated.
template <std::size_t S>
consteval bool proven(const Tableau<S>& tableau) {
  return has_exactly_order(tableau, tableau.b, tableau.order) &&
         (!tableau.embedded() || has_exactly_order(tableau, tableau.b_hat, tableau.order_hat));
}

}  // namespace odeum
