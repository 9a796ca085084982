// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "odeum/tableau/dynamic_tableau.hpp"
#include "odeum/tableau/rooted_trees.hpp"

/// Order conditions at run time, over any number type: in exact fractions a condition holds exactly
/// or not at all.
namespace odeum {

/// Bound on the error of each coefficient: its `absolute`, plus `relative` times its size (half a
/// unit in the last place for numbers held as double).
struct CoefficientRounding {
  double absolute = 0, relative = 0;
};
/// For coefficients held as double, a few of them computed by a short expression in double.
inline constexpr CoefficientRounding double_rounding{.absolute = 0, .relative = 0x1p-51};

/// The result of checking the order conditions of a row of weights.
template <class Number>
struct RowOrder {
  int order = 0;       ///< every condition up to it holds
  bool fails = false;  ///< a condition of the next order fails; else `order` is the highest checked
  std::size_t tree = 0;     ///< the first condition that fails
  Number residual{};        ///< sum_i b_i Phi_i(tau) - 1/gamma(tau) of that tree
  int failing = 0, of = 0;  ///< how many conditions of the next order fail, and how many there are
};

namespace detail {
inline double as_double(double x) { return x; }
inline double as_double(long double x) { return static_cast<double>(x); }
template <class Number>
double as_double(const Number& x) {
  return x.get_d();  // GMP's
}
}  // namespace detail

/// The order of a row with the stages of `tableau`, nodes taken from the row sums. A condition
/// holds where its residual is zero or within what the rounding of the coefficients explains: to
/// first order, (number of factors) x (relative rounding) x sum |b_i| Phi_i(|A|), and as much for
/// the absolute one with one factor left out. `at_most`: the highest order whose conditions are
/// checked.
template <class Number>
RowOrder<Number> order_of_row(const DynamicTableau<Number>& tableau, const std::vector<Number>& row,
                              const CoefficientRounding& rounding,
                              int at_most = highest_order_checked) {
  const std::size_t s = tableau.stages;
  constexpr const auto& trees = all_rooted_trees;
  std::vector<std::vector<Number>> phi;
  std::vector<std::vector<double>> size, slope;  // Phi(|A|), and its derivative by a shift of all
  std::vector<double> magnitude(s * s), weight(s);
  for (std::size_t k = 0; k < s * s; ++k) magnitude[k] = std::abs(detail::as_double(tableau.a[k]));
  for (std::size_t i = 0; i < s; ++i) weight[i] = std::abs(detail::as_double(row[i]));

  RowOrder<Number> result;
  std::size_t tau = 0;
  for (int order = 1; order <= at_most; ++order) {
    for (; tau < trees.count && trees.nodes[tau] == order; ++tau) {
      phi.emplace_back(s, Number(1));
      size.emplace_back(s, 1.0);
      slope.emplace_back(s, 0.0);
      Number sum(0);
      double sum_size = 0, sum_slope = 0;
      for (std::size_t i = 0; i < s; ++i) {
        if (tau != 0) {
          const std::size_t l = trees.left[tau], r = trees.right[tau];
          Number graft(0);
          double graft_size = 0, graft_slope = 0;
          for (std::size_t j = 0; j < s; ++j) {
            const double a = magnitude[i * s + j];
            if (a == 0) continue;  // a zero is exact
            graft_slope += size[r][j] + a * slope[r][j];
            graft += tableau.at(i, j) * phi[r][j];
            graft_size += a * size[r][j];
          }
          phi[tau][i] = phi[l][i] * graft;
          size[tau][i] = size[l][i] * graft_size;
          slope[tau][i] = slope[l][i] * graft_size + size[l][i] * graft_slope;
        }
        sum += row[i] * phi[tau][i];
        sum_size += weight[i] * size[tau][i];
        if (weight[i] != 0) sum_slope += size[tau][i] + weight[i] * slope[tau][i];
      }
      const Number exact = Number(1) / Number(trees.density[tau]);
      const Number residual = sum - exact;
      const double allowance = order * rounding.relative * sum_size + rounding.absolute * sum_slope;
      ++result.of;
      if (std::abs(detail::as_double(residual)) <= allowance) continue;
      if (result.failing++ == 0) {
        result.tree = tau;
        result.residual = residual;
      }
    }
    if (result.failing > 0) {
      result.fails = true;
      return result;
    }
    result.order = order;
    result.of = 0;
  }
  return result;
}

}  // namespace odeum
