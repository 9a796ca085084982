// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/tableau/nystroem.hpp"

/// Symplectic splitting of q'' = a(t, q) into kicks (v changes) and drifts (q and t change).
namespace odeum {

/// In turn, for i = 0, 1, ...:  v <- v + h kick_i a(t, q);  q <- q + h drift_i v, t <- t + h
/// drift_i. A splitting that begins with a drift has kick_0 = 0, one that ends with a kick has a
/// last drift of 0. Symplectic whatever the coefficients are.
template <std::size_t S>
struct Splitting {
  static constexpr std::size_t stages = S;
  std::array<double, S> kick{}, drift{};
  int order = 0;

  /// Fraction of the step before kick i.
  constexpr double c(std::size_t i) const {
    double sum = 0;
    for (std::size_t j = 0; j < i; ++j) sum += drift[j];
    return sum;
  }
  /// It ends with a kick where the next step begins with one: the acceleration serves both.
  constexpr bool reuses_last_stage() const { return drift[S - 1] == 0 && kick[0] != 0; }
  /// Symmetric coefficients: a step with -h inverts a step with h.
  constexpr bool symmetric() const {
    const bool kicks_at_ends = drift[S - 1] == 0;  // else it has to begin with a drift: kick_0 = 0
    if (!kicks_at_ends && kick[0] != 0) return false;
    for (std::size_t i = 0; i < S; ++i) {
      const std::size_t k = kicks_at_ends ? S - 1 - i : S - i;
      if (k < S && !near(kick[i], kick[k])) return false;
      const std::size_t d = kicks_at_ends ? S - 2 - i : S - 1 - i;
      if (d < S && !near(drift[i], drift[d])) return false;
    }
    return true;
  }
  /// The equivalent explicit Nystroem method, whose order conditions prove it.
  constexpr NystroemTableau<S> as_nystroem() const {
    NystroemTableau<S> n;
    n.order = order;
    double end = 0;
    for (const double d : drift) end += d;
    for (std::size_t i = 0; i < S; ++i) {
      n.c[i] = c(i);
      n.b_v[i] = kick[i];
      n.b_q[i] = kick[i] * (end - n.c[i]);
      for (std::size_t j = 0; j < i; ++j) n.a[i][j] = kick[j] * (n.c[i] - n.c[j]);
    }
    return n;
  }

 private:
  static constexpr bool near(double x, double y) {
    const double d = x - y;
    return d < 1e-15 && d > -1e-15;  // some roundings of sums of size one
  }
};

/// The first fault: the drifts do not add up to one step, or a condition of the order stated fails.
template <std::size_t S>
constexpr OrderFault first_fault(const Splitting<S>& splitting) {
  if (const double rest = splitting.c(S - 1) + splitting.drift[S - 1] - 1; !is_rounding(rest))
    return {.row = WeightRow::drift, .order = 1, .tree = 0, .residual = rest};
  return first_fault(splitting.as_nystroem());
}

template <int Order, std::size_t Index, std::size_t S>
constexpr auto tree_of_fault(const Splitting<S>&) {
  return tree_at<nystroem_trees<Order>, Index>();
}

/// Kicks and drifts of the composition of velocity-Verlet steps of lengths w_0 h, w_1 h, ...
template <std::size_t N>
constexpr Splitting<N + 1> compose_verlet(const std::array<double, N>& w, int order) {
  Splitting<N + 1> splitting;
  splitting.order = order;
  for (std::size_t i = 0; i < N; ++i) {
    splitting.drift[i] = w[i];
    splitting.kick[i] += w[i] / 2;
    splitting.kick[i + 1] += w[i] / 2;
  }
  return splitting;
}

/// The symmetric composition whose middle length w_0 follows from the others, w_1 (next to the
/// middle), w_2, ..., so that they add up to one.
template <std::size_t M>
constexpr std::array<double, 2 * M + 1> around_the_middle(const std::array<double, M>& outer) {
  std::array<double, 2 * M + 1> w{};
  w[M] = 1;
  for (std::size_t i = 0; i < M; ++i) {
    w[M + 1 + i] = w[M - 1 - i] = outer[i];
    w[M] -= 2 * outer[i];
  }
  return w;
}

}  // namespace odeum
