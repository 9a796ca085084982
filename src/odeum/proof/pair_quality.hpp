// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/proof/embedded_check.hpp"
#include "odeum/tableau/dynamic_tableau.hpp"

namespace odeum::proof {

/// The Euclidean norm of a row's error coefficients of one order,
/// (sum_i b_i Phi_i(tau) - 1/gamma(tau)) / sigma(tau) over all trees tau with so many nodes: zero
/// where the order's conditions hold, A(p+1) of Prince and Dormand for the first that do not. With
/// `exact` in place of the 1: 0 for a difference of two rows.
double error_norm(const DynamicTableau<double>& tableau, const std::vector<double>& row, int order,
                  double exact = 1);

/// Quality measures of a method or a pair besides the orders (Prince, Dormand, J. Comput. Appl.
/// Math. 7 (1981) 67-75). The lower row is the one of less order, of order q - 1.
struct PairQuality {
  /// The principal error norms A of b and b_hat; that of b_hat is NaN without a pair.
  double principal_error = nan, embedded_principal_error = nan;
  /// B, of the lower row: A(q+1) / A(q). Its leading error term dominates where B is small.
  double next_term_ratio = nan;
  /// C: |tau(q+1) of the rows' difference| / A(q) of the lower row.
  double difference_ratio = nan;
  double largest_coefficient = 0;  ///< D
  double rows_ratio = nan;         ///< E: A(q+1) of the higher row / A(q) of the lower one
  /// A(q) of the lower row beside the whole term h^q of the solution, whose coefficients are
  /// 1 / (gamma sigma).
  double solution_term_ratio = nan;
  std::vector<EstimateQuality> estimate;  ///< measured; empty without a pair

  /// What is unusual in these numbers, a sentence each.
  std::vector<std::string> remarks() const;
  std::string text() const;
};

/// `order` and `order_hat`: as proven; 0: there is no such row, or it is not consistent.
PairQuality pair_quality(const DynamicTableau<double>& tableau, int order, int order_hat);

}  // namespace odeum::proof
