// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/order_conditions.hpp"

/// Runge-Kutta-Nystroem coefficients for q'' = a(t, q) as data, and their order conditions (Hairer,
/// Norsett, Wanner, Solving ODEs I, II.14).
namespace odeum {

///     g_i = q + c_i h v + h^2 sum_j a_ij a(t + c_j h, g_j),
///     q <- q + h v + h^2 sum_i b_q_i a(t + c_i h, g_i),   v <- v + h sum_i b_v_i a(t + c_i h,
///     g_i),
/// with an embedded pair of rows where `order_hat` is not 0.
template <std::size_t S>
struct NystroemTableau {
  static constexpr std::size_t stages = S;
  std::array<double, S> c{};
  std::array<std::array<double, S>, S> a{};
  std::array<double, S> b_q{}, b_v{};
  int order = 0;
  std::array<double, S> b_q_hat{}, b_v_hat{};
  int order_hat = 0;

  constexpr bool is_explicit() const { return zero_from(a, 0); }
  constexpr bool has_embedded_rows() const { return order_hat != 0; }
  /// First same as last: the last stage is the first of the next step.
  constexpr bool reuses_last_stage() const {
    for (std::size_t j = 0; j < S; ++j)
      if (a[S - 1][j] != b_q[j]) return false;
    return c[0] == 0 && c[S - 1] == 1;
  }
};

/// The special Nystroem trees with at most MaxOrder nodes, each made from an earlier one by adding
/// to its root a velocity (`right` = velocity) or a smaller tree. A tree of n nodes contributes
/// to v at h^n and to q at h^(n+1).
template <int MaxOrder>
struct NystroemTrees {
  static constexpr std::array<std::size_t, 11> count_to{0, 1, 2, 4, 7, 13, 23, 43, 79, 151, 288};
  static_assert(MaxOrder >= 1 && MaxOrder <= 10);
  static constexpr std::size_t count = count_to[MaxOrder];
  static constexpr std::size_t velocity = count;

  std::array<int, count> nodes{};
  std::array<std::size_t, count> left{}, right{};
  /// The factor of the exact solution; at a stage at theta it is multiplied by theta^(n-1).
  std::array<double, count> factor{};

  consteval NystroemTrees() {
    nodes[0] = 1;
    factor[0] = 1;
    std::size_t made = 1;
    const auto add = [&](int n, std::size_t l, std::size_t r) {
      nodes[made] = n;
      left[made] = l;
      right[made] = r;
      factor[made] = factor[l] * (r == velocity ? 1 : factor[r] / (nodes[r] * (nodes[r] + 1)));
      ++made;
    };
    for (int n = 2; n <= MaxOrder; ++n) {
      const std::size_t smaller = made;
      for (std::size_t l = 0; l < smaller; ++l) {
        // Velocities last, trees in non-increasing order before them: each tree once.
        if (nodes[l] + 1 == n) add(n, l, velocity);
        if (l != 0 && right[l] == velocity) continue;
        for (std::size_t r = 0; r < smaller; ++r)
          if (nodes[l] + nodes[r] + 1 == n && (l == 0 || r <= right[l])) add(n, l, r);
      }
    }
    if (made != count) throw "Nystroem trees miscounted";
  }
};

template <int MaxOrder>
inline constexpr NystroemTrees<MaxOrder> nystroem_trees{};

/// Calls visit(row, order, tau, residual) for each condition up to `Order`: those on the velocity's
/// row by the trees of as many nodes, those on the position's row by the trees of one node less.
template <int Order, std::size_t S, class Visit>
constexpr void for_each_condition(const NystroemTableau<S>& tableau,
                                  const std::array<double, S>& row_q,
                                  const std::array<double, S>& row_v, Visit&& visit) {
  constexpr const auto& trees = nystroem_trees<Order>;
  double phi[trees.count][S]{};
  for (std::size_t tau = 0; tau < trees.count; ++tau) {
    const std::size_t r = trees.right[tau];
    double sum_q = 0, sum_v = 0;
    for (std::size_t i = 0; i < S; ++i) {
      double graft = tableau.c[i];
      if (tau != 0 && r != trees.velocity) {
        graft = 0;
        for (std::size_t j = 0; j < S; ++j) graft += tableau.a[i][j] * phi[r][j];
      }
      phi[tau][i] = tau == 0 ? 1 : phi[trees.left[tau]][i] * graft;
      sum_q += row_q[i] * phi[tau][i];
      sum_v += row_v[i] * phi[tau][i];
    }
    const int n = trees.nodes[tau];
    visit(WeightRow::b_v, n, tau, sum_v - trees.factor[tau] / n);
    if (n < Order) visit(WeightRow::b_q, n + 1, tau, sum_q - trees.factor[tau] / (n * (n + 1)));
  }
}

/// The first condition up to `order` (at most 8) that the rows do not meet, or that they meet all
/// of the next order.
template <std::size_t S>
constexpr OrderFault order_fault(const NystroemTableau<S>& tableau,
                                 const std::array<double, S>& row_q,
                                 const std::array<double, S>& row_v, int order) {
  FaultSearch search{.order = order};
  for_each_condition<9>(tableau, row_q, row_v,
                        [&](WeightRow row, int n, std::size_t tau, double residual) {
                          search.take(row, n, tau, residual);
                        });
  return search.result();
}

/// The first fault of either pair of rows; order 0 where there is none.
template <std::size_t S>
constexpr OrderFault first_fault(const NystroemTableau<S>& tableau) {
  OrderFault fault = order_fault(tableau, tableau.b_q, tableau.b_v, tableau.order);
  if (fault.order != 0) return fault;
  fault = order_fault(tableau, tableau.b_q_hat, tableau.b_v_hat, tableau.order_hat);
  fault.row = fault.row == WeightRow::b_q ? WeightRow::b_q_hat : WeightRow::b_v_hat;
  return fault;
}

template <int Order, std::size_t Index, std::size_t S>
constexpr auto tree_of_fault(const NystroemTableau<S>&) {
  return tree_at<nystroem_trees<Order>, Index>();
}

}  // namespace odeum
