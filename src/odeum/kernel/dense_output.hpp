// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/order_conditions.hpp"

/// States between the two ends of a step (Hairer, Norsett, Wanner, Solving ODEs I, II.6).
namespace odeum {

/// Hermite's cubic at t + theta h, theta in [0, 1], from states and slopes at t and t + h: order 3,
/// continuously differentiable from step to step.
template <class S>
void cubic_hermite(double theta, double h, const S& y0, const S& f0, const S& y1, const S& f1,
                   S& y) {
  const double rest = 1 - theta;
  for (std::size_t n = 0; n < y.size(); ++n) {
    const double rise = y1[n] - y0[n];
    y[n] = y0[n] + theta * (rise + rest * (rest * (h * f0[n] - rise) - theta * (h * f1[n] - rise)));
  }
}

/// An interpolant of order 4 of a first-same-as-last tableau is Hermite's cubic and one term more,
///
///     y(t + theta h) = cubic(theta) + theta^2 (1 - theta)^2 h sum_i d_i k_i,
///
/// which changes neither value nor slope at the ends, so that the row d defines it. The weights
/// b_i(theta) of the sum of both:
template <std::size_t S>
constexpr std::array<double, S> weights_between(const Tableau<S>& tableau,
                                                const std::array<double, S>& d, double theta) {
  const double rest = 1 - theta, bump = theta * theta * rest * rest;
  std::array<double, S> b{};
  for (std::size_t i = 0; i < S; ++i) {
    const double rise = tableau.b[i], f0 = i == 0, f1 = i == S - 1;
    b[i] = theta * (rise + rest * (rest * (f0 - rise) - theta * (f1 - rise))) + bump * d[i];
  }
  return b;
}

/// The first condition sum_i b_i(theta) Phi_i(tau) = theta^|tau| / gamma(tau) of a tree of at most
/// 4 nodes that fails (its residual over theta^|tau|); order 0: none does. Both sides are
/// polynomials of degree 4 in theta, which vanish at 0: four points suffice.
template <std::size_t S>
constexpr OrderFault interpolation_fault(const Tableau<S>& tableau,
                                         const std::array<double, S>& d) {
  OrderFault fault{.row = WeightRow::dense};
  for (const double theta : {1. / 4, 1. / 2, 3. / 4, 1.}) {
    // With A / theta as its coefficients the tableau has its stages on the step theta h.
    Tableau<S> scaled = tableau;
    std::array<double, S> row = weights_between(tableau, d, theta);
    for (std::size_t i = 0; i < S; ++i) {
      row[i] /= theta;
      for (std::size_t j = 0; j < S; ++j) scaled.a[i][j] /= theta;
    }
    // The division enlarges coefficients up to 4 times, products of three up to 64 times.
    for_each_condition<4>(scaled, row, [&](std::size_t tau, double residual) {
      const bool fails = residual > 64 * order_rounding || -residual > 64 * order_rounding;
      if (fails && fault.order == 0)
        fault = {WeightRow::dense, rooted_trees<4>.nodes[tau], tau, residual};
    });
  }
  return fault;
}

/// For static_assert beside a row d: the compiler's message names what fails, as of proven().
template <const auto& tableau, const auto& d>
consteval bool interpolates() {
  static_assert(tableau.first_same_as_last(), "the cubic needs the slope at the end of the step");
  constexpr OrderFault fault = interpolation_fault(tableau, d);
  constexpr int nodes = fault.order == 0 ? 1 : fault.order;
  return no_fault<fault.row, fault.order, decltype(tree_of_fault<nodes, fault.tree>(tableau)),
                  three_digits(fault.residual)>();
}

/// The state at t + theta h of the step from y0 to y1 that the stepper has just made (before
/// advance()): by the method's own row d where it has one, else by Hermite's cubic. Without a last
/// stage that is the first of the next step, f1 = f(t + h, y1) is one evaluation for the caller.
template <class M, class Stepper, class S>
void interpolate(const Stepper& stepper, double theta, double h, const S& y0, const S& y1,
                 const S& f1, S& y) {
  cubic_hermite(theta, h, y0, stepper.first_stage(), y1, f1, y);
  if constexpr (requires { M::dense_row; }) {
    S bump = y;
    stepper.template weighted_sum<M::dense_row>(h, bump);
    const double factor = theta * theta * (1 - theta) * (1 - theta);
    for (std::size_t n = 0; n < y.size(); ++n) y[n] += factor * bump[n];
  }
}

}  // namespace odeum
