// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/order_conditions.hpp"

/// Coefficients of Rosenbrock methods (Hairer, Wanner, Solving ODEs II, IV.7): with J = df/dy,
///
///     k_i = h f(t + alpha_i h, y + sum_{j<i} alpha_ij k_j) + h J sum_{j<=i} gamma_ij k_j
///           + gamma_i h^2 df/dt,          y <- y + sum_i b_i k_i,
///
/// alpha_i and gamma_i the row sums, the diagonal gamma_ii the same in all stages.
namespace odeum {

/// The method in the variables u = Gamma k, which need no product with J (IV.7, (7.25)):
///
///     (I / (gamma h) - J) u_i = f(t + alpha_i h, y + sum a_ij u_j) + sum c_ij u_j / h
///                               + gamma_i h df/dt,          y <- y + sum m_i u_i.
///
/// Methods are published in one form or the other; the other form is derived.
template <std::size_t S>
struct RosenbrockTableau {
  static constexpr std::size_t stages = S;
  using Matrix = std::array<std::array<double, S>, S>;
  using Row = std::array<double, S>;
  double gamma = 0;
  Matrix a{}, c{};
  Row m{};
  int order = 0;
  Row m_hat{};  ///< the embedded row
  int order_hat = 0;
  /// What the conditions leave: coefficients of size up to a hundred, published to 16 digits, need
  /// more than the default.
  double rounding = 1e-13;

  constexpr bool embedded() const { return order_hat != 0; }

  /// Gamma, from its inverse I / gamma - C, which is lower triangular.
  constexpr Matrix gamma_matrix() const {
    Matrix inverse{};
    for (std::size_t j = 0; j < S; ++j)
      for (std::size_t i = j; i < S; ++i) {
        double sum = i == j ? 1 : 0;
        for (std::size_t k = j; k < i; ++k) sum += c[i][k] * inverse[k][j];
        inverse[i][j] = sum * gamma;
      }
    return inverse;
  }
  constexpr Matrix alpha_matrix() const {
    const Matrix g = gamma_matrix();
    Matrix alpha{};
    for (std::size_t i = 0; i < S; ++i)
      for (std::size_t j = 0; j < S; ++j)
        for (std::size_t k = 0; k < S; ++k) alpha[i][j] += a[i][k] * g[k][j];
    return alpha;
  }
  /// b = m Gamma.
  constexpr Row weights(const Row& row) const {
    const Matrix g = gamma_matrix();
    Row b{};
    for (std::size_t j = 0; j < S; ++j)
      for (std::size_t k = 0; k < S; ++k) b[j] += row[k] * g[k][j];
    return b;
  }
  static constexpr Row row_sums(const Matrix& matrix) {
    Row sums{};
    for (std::size_t i = 0; i < S; ++i)
      for (const double entry : matrix[i]) sums[i] += entry;
    return sums;
  }
  /// alpha + Gamma with the weights b: on y' = z y the method is this Runge-Kutta method.
  constexpr Tableau<S> linear_tableau() const {
    const Matrix g = gamma_matrix(), alpha = alpha_matrix();
    Tableau<S> t;
    for (std::size_t i = 0; i < S; ++i)
      for (std::size_t j = 0; j < S; ++j) t.a[i][j] = alpha[i][j] + g[i][j];
    t.b = weights(m);
    return t;
  }
};

/// The tableau from alpha, Gamma (with its diagonal) and b.
template <std::size_t S>
constexpr RosenbrockTableau<S> rosenbrock_from(const std::array<std::array<double, S>, S>& alpha,
                                               const std::array<std::array<double, S>, S>& gamma,
                                               const std::array<double, S>& b, int order,
                                               const std::array<double, S>& b_hat = {},
                                               int order_hat = 0) {
  // Row times the inverse of Gamma, by substitution from the right.
  const auto over_gamma = [&](std::array<double, S> row) {
    for (std::size_t j = S; j-- > 0;) {
      for (std::size_t k = j + 1; k < S; ++k) row[j] -= row[k] * gamma[k][j];
      row[j] /= gamma[j][j];
    }
    return row;
  };
  RosenbrockTableau<S> t;
  t.gamma = gamma[0][0];
  for (std::size_t i = 0; i < S; ++i) {
    t.a[i] = over_gamma(alpha[i]);
    std::array<double, S> unit{};
    unit[i] = 1;
    const auto inverse_row = over_gamma(unit);
    for (std::size_t j = 0; j < i; ++j) t.c[i][j] = -inverse_row[j];
  }
  t.m = over_gamma(b);
  t.m_hat = over_gamma(b_hat);
  t.order = order;
  t.order_hat = order_hat;
  return t;
}

/// Calls visit(tau, residual) for each rooted tree with at most `Order` nodes: the order conditions
/// of Runge-Kutta methods on a row of b, but for a node with a single child, whose edge takes alpha
/// + Gamma instead of alpha (theorem 7.4; with Gamma's diagonal included the right-hand side is 1 /
/// gamma(tau)). Since alpha_i and gamma_i are row sums they cover non-autonomous problems too.
template <int Order, std::size_t S, class Visit>
constexpr void for_each_condition(const RosenbrockTableau<S>& tableau,
                                  const std::array<double, S>& b, Visit&& visit) {
  constexpr const auto& trees = rooted_trees<Order>;
  const auto alpha = tableau.alpha_matrix(), gamma = tableau.gamma_matrix();
  std::array<std::array<double, S>, trees.count> phi{};   // as the whole tree
  std::array<std::array<double, S>, trees.count> many{};  // as one of several branches
  for (std::size_t tau = 0; tau < trees.count; ++tau) {
    double sum = 0;
    for (std::size_t i = 0; i < S; ++i) {
      phi[tau][i] = many[tau][i] = 1;
      if (tau != 0) {
        double graft = 0, alone = 0;
        for (std::size_t j = 0; j < S; ++j) {
          graft += alpha[i][j] * phi[trees.right[tau]][j];
          alone += gamma[i][j] * phi[trees.right[tau]][j];
        }
        many[tau][i] = many[trees.left[tau]][i] * graft;
        phi[tau][i] = trees.left[tau] == 0 ? graft + alone : many[tau][i];
      }
      sum += b[i] * phi[tau][i];
    }
    visit(tau, sum - 1 / trees.density[tau]);
  }
}

/// The first condition up to `order` (at most 5) that a row of m does not meet, or that it meets
/// all of the next order.
template <std::size_t S>
constexpr OrderFault order_fault(const RosenbrockTableau<S>& tableau,
                                 const std::array<double, S>& m, int order) {
  FaultSearch search{
      .order = order, .rounding = tableau.rounding, .certain = 10 * tableau.rounding};
  for_each_condition<6>(tableau, tableau.weights(m), [&](std::size_t tau, double residual) {
    search.take(WeightRow::b, rooted_trees<6>.nodes[tau], tau, residual);
  });
  return search.result();
}

template <std::size_t S>
constexpr OrderFault first_fault(const RosenbrockTableau<S>& tableau) {
  return first_fault(tableau, tableau.m, tableau.m_hat);
}

}  // namespace odeum
