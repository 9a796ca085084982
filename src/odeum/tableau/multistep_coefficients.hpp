// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/collocation.hpp"
#include "odeum/tableau/proof_message.hpp"

/// Coefficients of linear multistep formulas, derived at compile time (Hairer, Norsett, Wanner,
/// Solving ODEs I, III.1):
///
///     sum_i alpha_i y_{n+1-i} = h sum_i beta_i f_{n+1-i},   i = 0 is the new point.
namespace odeum {

template <std::size_t K>
struct MultistepCoefficients {
  static constexpr std::size_t steps = K;
  std::array<double, K + 1> alpha{}, beta{};
};

/// Integrals from 0 to 1 of Lagrange's polynomials on the nodes first, first - 1, ...
template <std::size_t Count>
constexpr std::array<double, Count> lagrange_integrals(int first) {
  Nodes<Count> nodes{};
  for (std::size_t m = 0; m < Count; ++m) nodes[m] = first - static_cast<int>(m);
  return collocation<Count>(nodes, 0).b;
}

/// Adams-Bashforth: y_{n+1} = y_n + h times the integral of the polynomial through f_n, ...,
/// f_{n+1-K}. Order K.
template <std::size_t K>
constexpr MultistepCoefficients<K> adams_bashforth_coefficients() {
  MultistepCoefficients<K> c;
  c.alpha[0] = 1;
  c.alpha[1] = -1;
  const auto beta = lagrange_integrals<K>(0);
  for (std::size_t i = 0; i < K; ++i) c.beta[i + 1] = beta[i];
  return c;
}

/// Adams-Moulton: the same through f_{n+1}, f_n, ..., f_{n+1-K}. Order K + 1.
template <std::size_t K>
constexpr MultistepCoefficients<K> adams_moulton_coefficients() {
  MultistepCoefficients<K> c;
  c.alpha[0] = 1;
  c.alpha[1] = -1;
  c.beta = lagrange_integrals<K + 1>(1);
  return c;
}

/// BDF: sum_{j=1}^K nabla^j y_{n+1} / j = h f_{n+1}. Order K.
template <std::size_t K>
constexpr MultistepCoefficients<K> backward_difference_coefficients() {
  MultistepCoefficients<K> c;
  c.beta[0] = 1;
  for (std::size_t j = 1; j <= K; ++j) {
    double binomial = 1;  // of j over i, with alternating sign
    for (std::size_t i = 0; i <= j; ++i) {
      c.alpha[i] += binomial / static_cast<double>(j);
      binomial *= -static_cast<double>(j - i) / static_cast<double>(i + 1);
    }
  }
  return c;
}

/// Why a formula does not have the order stated for it.
struct MultistepFault {
  int degree = -1;      ///< of the first condition that fails; -1: the order is as stated
  double residual = 0;  ///< of that condition over its largest term; 0: the order is higher
};

/// The first q up to `order` for which the formula is not exact on the polynomial t^q, or `order` +
/// 1 where it is exact on that as well ((III.2.6)).
template <std::size_t K>
constexpr MultistepFault multistep_fault(const MultistepCoefficients<K>& c, int order) {
  const auto residual = [&](int q) {
    double sum = 0, largest = 1;
    for (std::size_t i = 0; i <= K; ++i) {
      const double x = 1 - static_cast<double>(i);  // t_{n+1-i}, h = 1, t_n = 0
      double power = 1;                             // x^(q-1)
      for (int k = 1; k < q; ++k) power *= x;
      const double value = q == 0 ? c.alpha[i] : c.alpha[i] * power * x - q * c.beta[i] * power;
      sum += value;
      largest = value > largest ? value : -value > largest ? -value : largest;
    }
    return sum / largest;
  };
  const auto exact = [&](int q, double rounding) {
    return residual(q) <= rounding && -residual(q) <= rounding;
  };
  for (int q = 0; q <= order; ++q)
    if (!exact(q, 1e-14)) return {q, residual(q)};
  if (exact(order + 1, 1e-10)) return {order + 1, 0};
  return {};
}

template <int degree, Decimal residual>
struct NotExactForPolynomial {
  static_assert(degree < 0,
                "the multistep formula is not exact for t to the power of this degree; the "
                "residual is relative to the largest term");
};
template <int order>
struct MultistepHasHigherOrderThanStated {
  static_assert(order < 0, "the multistep formula has this order as well");
};

/// For static_assert beside a formula: it has exactly that order. Where it has not, the compiler's
/// message names the condition and its residual.
template <const auto& formula, int order>
consteval bool multistep_proven() {
  constexpr MultistepFault fault = multistep_fault(formula, order);
  constexpr Decimal residual = three_digits(fault.residual);
  if constexpr (fault.degree >= 0 && residual.digits == 0)
    (void)MultistepHasHigherOrderThanStated<fault.degree>{};
  else if constexpr (fault.degree >= 0)
    (void)NotExactForPolynomial<fault.degree, residual>{};
  return fault.degree < 0;
}

}  // namespace odeum
