// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/tableau.hpp"

/// Collocation methods from their nodes (Hairer, Wanner, Solving ODEs II, IV.5), derived in long
/// double at compile time.
namespace odeum {

/// P_n(2x - 1), Legendre's polynomial on [0, 1], by its recurrence.
constexpr long double shifted_legendre(int n, long double x) {
  const long double u = 2 * x - 1;
  long double before = 1, p = u;
  if (n == 0) return before;
  for (int k = 1; k < n; ++k) {
    const long double next = ((2 * k + 1) * u * p - k * before) / (k + 1);
    before = p;
    p = next;
  }
  return p;
}

template <std::size_t S>
using Nodes = std::array<long double, S>;

/// The first `count` roots of f in (0, 1): by changes of sign on a grid, then bisection.
template <std::size_t S, class F>
constexpr Nodes<S> roots_in_unit_interval(F f, std::size_t count) {
  constexpr int grid = 1009;  // prime, so that no root lies on the grid
  Nodes<S> roots{};
  std::size_t found = 0;
  for (int g = 0; g < grid && found < count; ++g) {
    long double low = static_cast<long double>(g) / grid;
    long double high = static_cast<long double>(g + 1) / grid;
    const bool rising = f(low) < 0;
    if (rising == (f(high) < 0)) continue;
    for (int halving = 0; halving < 70; ++halving) {
      const long double middle = (low + high) / 2;
      ((f(middle) < 0) == rising ? low : high) = middle;
    }
    roots[found++] = (low + high) / 2;
  }
  if (found != count) throw "roots missed";
  return roots;
}

/// Gauss: the roots of P_S. Order 2S.
template <std::size_t S>
constexpr Nodes<S> gauss_nodes() {
  return roots_in_unit_interval<S>([](long double x) { return shifted_legendre(S, x); }, S);
}

/// Radau, right: the roots of P_S - P_{S-1}, the last of which is 1. Order 2S - 1.
template <std::size_t S>
constexpr Nodes<S> radau_right_nodes() {
  auto nodes = roots_in_unit_interval<S>(
      [](long double x) { return shifted_legendre(S, x) - shifted_legendre(S - 1, x); }, S - 1);
  nodes[S - 1] = 1;
  return nodes;
}

/// a_ij = integral from 0 to c_i of Lagrange's polynomial l_j, b_j that to 1.
template <std::size_t S>
constexpr Tableau<S> collocation(const Nodes<S>& c, int order) {
  Tableau<S> t;
  t.order = order;
  for (std::size_t j = 0; j < S; ++j) {
    std::array<long double, S> l{1};  // coefficients, lowest first
    for (std::size_t m = 0, degree = 0; m < S; ++m) {
      if (m == j) continue;
      const long double scale = 1 / (c[j] - c[m]);
      ++degree;
      for (std::size_t k = degree + 1; k-- > 0;)
        l[k] = ((k > 0 ? l[k - 1] : 0) - (k < degree ? c[m] * l[k] : 0)) * scale;
    }
    const auto integral = [&](long double x) {
      long double sum = 0;
      for (std::size_t k = S; k-- > 0;) sum = sum * x + l[k] / static_cast<long double>(k + 1);
      return sum * x;
    };
    for (std::size_t i = 0; i < S; ++i) t.a[i][j] = static_cast<double>(integral(c[i]));
    t.b[j] = static_cast<double>(integral(1));
  }
  return t;
}

/// Butcher's simplifying assumptions prove an order without rooted trees (theorem IV.5.1): B(p),
/// C(eta), D(zeta) with p <= eta + zeta + 1 and p <= 2 eta + 2. B(p + 1) must fail: the order is
/// exact.
template <std::size_t S>
consteval bool collocation_proven(const Tableau<S>& t, int eta, int zeta) {
  constexpr double rounding = 1e-14;
  const int p = t.order;
  if (p > eta + zeta + 1 || p > 2 * eta + 2) return false;
  const auto power = [](double x, int n) {
    double result = 1;
    for (int k = 0; k < n; ++k) result *= x;
    return result;
  };
  const auto small = [](double x) { return x < rounding && -x < rounding; };
  const auto b_violation = [&](int q) {
    double sum = 0;
    for (std::size_t i = 0; i < S; ++i) sum += t.b[i] * power(t.c(i), q - 1);
    return sum - 1.0 / q;
  };
  for (int q = 1; q <= p; ++q)
    if (!small(b_violation(q))) return false;
  for (std::size_t i = 0; i < S; ++i) {
    for (int q = 1; q <= eta; ++q) {
      double sum = 0;
      for (std::size_t j = 0; j < S; ++j) sum += t.a[i][j] * power(t.c(j), q - 1);
      if (!small(sum - power(t.c(i), q) / q)) return false;
    }
    for (int q = 1; q <= zeta; ++q) {
      double sum = 0;
      for (std::size_t j = 0; j < S; ++j) sum += t.b[j] * power(t.c(j), q - 1) * t.a[j][i];
      if (!small(sum - t.b[i] * (1 - power(t.c(i), q)) / q)) return false;
    }
  }
  return !small(b_violation(p + 1));
}

}  // namespace odeum
