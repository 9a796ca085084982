// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "odeum/kernel/stabilised_rk.hpp"
#include "odeum/tableau/weighted_chebyshev.hpp"

namespace odeum {

/// Elementary weights of a state that a Runge-Kutta method forms, for the trees of up to four
/// nodes: t, [t], [t,t], [[t]], [t,t,t], [t,[t]], [[t,t]], [[[t]]] (Hairer, Norsett, Wanner,
/// Solving ODEs I, II.2). Sums of states sum them.
using ElementaryWeights = std::array<double, 8>;
/// The weights of the exact solution: one over the densities of the trees.
inline constexpr ElementaryWeights exact_weights{1,       1.0 / 2, 1.0 / 3,  1.0 / 6,
                                                 1.0 / 4, 1.0 / 8, 1.0 / 12, 1.0 / 24};

/// The weights of h f(y): those of y times one another, for each branch of the root.
inline ElementaryWeights slope_of(const ElementaryWeights& y) {
  return {1, y[0], y[0] * y[0], y[1], y[0] * y[0] * y[0], y[0] * y[1], y[2], y[3]};
}
inline void add_multiple(double factor, const ElementaryWeights& x, ElementaryWeights& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * x[i];
}

/// The stages of P_n(z), P_n(0) = 1, of a weighted polynomial, and of more that follow.
struct OrthogonalStages {
  std::vector<StabilisedStage> stages;
  ElementaryWeights before{}, now{};  ///< of the last two states

  template <std::size_t N>
  explicit OrthogonalStages(const WeightedPolynomial<N>& r) {
    const std::vector<double>&a = r.recurrence.a, &b = r.recurrence.b;
    double quotient = 0;  // P_{j-1} / P_j at the start
    for (std::size_t j = 0; j < a.size(); ++j) {
      // P_{j+1} / P_j = x - a_j - b_j P_{j-1} / P_j
      quotient = 1 / (r.start - a[j] - b[j] * quotient);
      add((r.start - a[j]) * quotient, quotient / r.scale);
    }
  }

  /// mu Y_{j-1} + (1 - mu) Y_{j-2} + h slope F_{j-1}.
  void add(double mu, double slope) {
    ElementaryWeights next{};
    add_multiple(mu, now, next);
    add_multiple(1 - mu, before, next);
    add_multiple(slope, slope_of(now), next);
    stages.push_back({mu, 1 - mu, slope, 0, next[0]});
    before = std::exchange(now, next);
  }
};

/// compute(s), computed once a program for each s.
template <int most, auto compute>
const auto& kept_by_degree(int s) {
  static std::array<std::once_flag, most + 1> once;
  static std::array<decltype(compute(s)), most + 1> kept;
  const auto at = static_cast<std::size_t>(s);
  std::call_once(once[at], [&] { kept[at] = compute(s); });
  return kept[at];
}

}  // namespace odeum
