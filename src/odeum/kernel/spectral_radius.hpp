// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "odeum/kernel/components.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// An estimate of the spectral radius of the Jacobian, from evaluations of the right-hand side
/// alone: the power method on differences f(t, y + v) - f(t, y), as in the code RKC (Sommeijer,
/// Shampine, Verwer, J. Comput. Appl. Math. 88 (1998) 315-326, section 4). The vector is kept, so
/// that later estimates take a few evaluations.
///
/// Two estimates in a row have to agree, so that no single evaluation decides. The first vector has
/// a share in every direction: one along f alone may never see the fastest.
///
/// Where the problem has the entries of its Jacobian, and in no row the others outweigh the largest
/// diagonal entry, as in equations of diffusion, its norm is near the radius and bounds it: one
/// Jacobian is less than the iterations.
template <Ode P>
class SpectralRadius {
 public:
  explicit SpectralRadius(const P& problem)
      : problem_(problem), direction_(make_state(problem)), moved_(direction_), slope_(direction_) {
    begin();
  }

  /// The radius at (t, y) with f = f(t, y); a bound as far as the iteration has converged.
  double operator()(double t, const State<P>& y, const State<P>& f) {
    constexpr double safety = 1.2, agreement = 0.01;
    constexpr int most = 60;
    if (const double bound = norm_of_jacobian(t, y); bound > 0) return bound;
    double radius = 0;
    int agreed = 0;
    for (int k = 0; k < most && agreed < 2; ++k) {
      const double before = radius;
      radius = iterate(t, y, f);
      if (!std::isfinite(radius)) break;
      agreed = std::abs(radius - before) <= agreement * radius ? agreed + 1 : 0;
    }
    return safety * radius;
  }

  /// Makes two iterations alone; successive looks along a solution make the vector the fastest one.
  /// The geometric mean of their quotients, each of which varies where f only rotates.
  double look(double t, const State<P>& y, const State<P>& f) {
    const double first = iterate(t, y, f);
    return std::sqrt(first * iterate(t, y, f));
  }

 private:
  static constexpr double root_of_rounding = 0x1p-26;
  /// 0: unknown, or far above the radius.
  double norm_of_jacobian([[maybe_unused]] double t, [[maybe_unused]] const State<P>& y) {
    if constexpr (WithSparsity<P> && WithJacobianEntries<P>) {
      const Sparsity* const pattern = problem_.sparsity();
      if (!pattern || !offers_jacobian_entries(problem_)) return 0;
      entries_.assign(pattern->entries(), 0);
      problem_.jacobian_entries(t, y.data(), entries_.data());
      double largest = 0, diagonal = 0;
      for (std::size_t i = 0; i < y.size(); ++i) {
        double sum = 0;
        for (int k = pattern->start[i]; k < pattern->start[i + 1]; ++k) {
          const double entry = std::abs(entries_[static_cast<std::size_t>(k)]);
          sum += entry;
          if (pattern->column[static_cast<std::size_t>(k)] == static_cast<int>(i))
            diagonal = std::max(diagonal, entry);
        }
        largest = std::max(largest, sum);
      }
      if (largest <= 2.1 * diagonal) return largest;
    }
    return 0;
  }
  void begin() {
    // A linear congruence: the same numbers in every run.
    std::uint32_t random = 1;
    for (std::size_t i = 0; i < direction_.size(); ++i) {
      random = 1664525 * random + 1013904223;
      direction_[i] = 0.5 + static_cast<double>(random) / 4294967296.0;
      if (i % 2 == 1) direction_[i] = -direction_[i];
    }
  }
  /// v <- (f(t, y + v) - f) for v as long as rounding allows; the quotient of their lengths.
  double iterate(double t, const State<P>& y, const State<P>& f) {
    const double distance = std::max(norm(y), 1e-8) * root_of_rounding, length = norm(direction_);
    if (!(length > 0)) return begin(), 0;  // at rest in this direction
    each_component(y, [&](std::size_t i) { moved_[i] = y[i] + distance / length * direction_[i]; });
    problem_.rhs(t, moved_.data(), slope_.data());
    each_component(y, [&](std::size_t i) { direction_[i] = slope_[i] - f[i]; });
    return norm(direction_) / distance;
  }
  static double norm(const State<P>& x) {
    return std::sqrt(sum_of_components(x, [&](std::size_t i) { return x[i] * x[i]; }));
  }

  const P& problem_;
  State<P> direction_, moved_, slope_;
  std::vector<double> entries_;
};

}  // namespace odeum
