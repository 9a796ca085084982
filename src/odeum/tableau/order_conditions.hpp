// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/proof_message.hpp"
#include "odeum/tableau/rooted_trees.hpp"
#include "odeum/tableau/tableau.hpp"

/// Order conditions by rooted trees (Hairer, Norsett, Wanner, Solving ODEs I, II.2): a method has
/// order p exactly when  sum_i b_i Phi_i(tau) = 1 / gamma(tau)  for every rooted tree tau with at
/// most p nodes. Evaluated at compile time, so that a wrong coefficient does not compile.
namespace odeum {

/// Calls visit(tau, residual) for each rooted tree with at most `Order` nodes, the smallest first:
/// residual = sum_i b_i Phi_i(tau) - 1 / gamma(tau) for the row of weights.
/// Plain arrays and the nonzero coefficients only: the compiler counts each operation.
template <int Order, std::size_t S, class Visit>
constexpr void for_each_condition(const Tableau<S>& tableau, const std::array<double, S>& row,
                                  Visit&& visit) {
  constexpr const auto& trees = rooted_trees<Order>;
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
    visit(tau, sum - 1 / trees.density[tau]);
  }
}

/// The largest residual of a condition that holds, with coefficients of size one to ten rounded to
/// double: a hundred roundings. The largest of the published pairs is 1e-14 (Tsitouras 5(4), whose
/// coefficients reach 13).
inline constexpr double order_rounding = 1e-13;
constexpr bool is_rounding(double residual) {
  return residual < order_rounding && -residual < order_rounding;
}

/// Why a row of weights does not have exactly the order stated for it.
struct OrderFault {
  WeightRow row = WeightRow::b;
  int order = 0;         ///< of the first condition that fails; 0: the row has the order stated
  std::size_t tree = 0;  ///< of that condition, its place among the rooted trees
  double residual = 0;   ///< of that condition; 0: none fails, the row has a higher order
};

/// Finds, from all conditions up to the order after the one stated, the fault of a row.
struct FaultSearch {
  int order = 0;                     ///< that is stated
  double rounding = order_rounding;  ///< a residual below it is none
  double certain = order_rounding;   ///< a residual above it shows that the order is no higher
  bool no_higher = false;
  OrderFault fault = {};

  constexpr void take(WeightRow row, int nodes, std::size_t tau, double residual) {
    const double size = residual < 0 ? -residual : residual;
    if (size < rounding) return;
    if (nodes <= order && (fault.order == 0 || nodes < fault.order))
      fault = {row, nodes, tau, residual};
    if (nodes == order + 1 && !(size < certain)) no_higher = true;
  }
  constexpr OrderFault result() const {
    return fault.order != 0 || no_higher ? fault : OrderFault{.order = order + 1};
  }
};

template <int Order, std::size_t S>
constexpr OrderFault order_fault_up_to(const Tableau<S>& tableau, const std::array<double, S>& row,
                                       int order) {
  // The conditions of order 11 are not evaluated.
  FaultSearch search{.order = order, .no_higher = order == 10};
  for_each_condition<Order>(tableau, row, [&](std::size_t tau, double residual) {
    search.take(WeightRow::b, rooted_trees<Order>.nodes[tau], tau, residual);
  });
  return search.result();
}

/// The first condition up to `order` (at most 10) that the row does not meet, or that it meets all
/// of the next order (which is not evaluated for order 10).
template <std::size_t S>
constexpr OrderFault order_fault(const Tableau<S>& tableau, const std::array<double, S>& row,
                                 int order) {
  if (order <= 2) return order_fault_up_to<3>(tableau, row, order);
  if (order <= 4) return order_fault_up_to<5>(tableau, row, order);
  if (order <= 5) return order_fault_up_to<6>(tableau, row, order);
  if (order <= 7) return order_fault_up_to<8>(tableau, row, order);
  return order == 8 ? order_fault_up_to<9>(tableau, row, order)
                    : order_fault_up_to<10>(tableau, row, order);
}

/// The first fault of two rows; order 0 where there is none. A row that is not there is zero and
/// has exactly order 0.
constexpr OrderFault first_fault(const auto& tableau, const auto& row, const auto& row_hat) {
  OrderFault fault = order_fault(tableau, row, tableau.order);
  if (fault.order != 0) return fault;
  fault = order_fault(tableau, row_hat, tableau.order_hat);
  fault.row = WeightRow::b_hat;
  return fault;
}
template <std::size_t S>
constexpr OrderFault first_fault(const Tableau<S>& tableau) {
  return first_fault(tableau, tableau.b, tableau.b_hat);
}

/// The tree of a fault of that order, as a type.
template <int Order, std::size_t Index>
constexpr auto tree_of_fault(const auto&) {
  return tree_at<rooted_trees<Order>, Index>();
}

/// For static_assert beside coefficients: all rows have exactly the orders stated. Where one has
/// not, the compiler's message names the fault, as template arguments, since only those are printed
/// with their values. Each kind of coefficients has its own first_fault and tree_of_fault.
template <const auto& coefficients>
consteval bool proven() {
  constexpr OrderFault fault = first_fault(coefficients);
  constexpr int nodes = fault.order == 0 ? 1 : fault.order;
  return no_fault<fault.row, fault.order, decltype(tree_of_fault<nodes, fault.tree>(coefficients)),
                  three_digits(fault.residual)>();
}

/// The same for a row of weights beside those of a tableau.
template <const auto& tableau, const auto& row, int order>
consteval bool row_proven() {
  constexpr OrderFault fault = order_fault(tableau, row, order);
  constexpr int nodes = fault.order == 0 ? 1 : fault.order;
  return no_fault<WeightRow::further, fault.order,
                  decltype(tree_of_fault<nodes, fault.tree>(tableau)),
                  three_digits(fault.residual)>();
}

}  // namespace odeum
