// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "odeum/linear/dense_lu.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum::linear {

/// The inverse of a row-major N x N matrix, N small and known at compile time: a solve by
/// multiplication has no chain of dependent operations, unlike a triangular solve, which repays the
/// more expensive factorisation after two or three solves. Same interface as DenseLu.
template <std::size_t N>
class SmallInverse {
 public:
  /// The argument is that of DenseLu.
  explicit SmallInverse(std::size_t /*n*/ = N) {}
  /// The N x N entries: fill them, then call factorise().
  double* data() { return a_.data(); }

  /// False where the matrix is singular or has an entry that is not finite.
  bool factorise() {
    if constexpr (N == 1)
      inverse_[0] = 1 / a_[0];
    else if constexpr (N <= 3)
      invert_by_cofactors();
    else if (!eliminate<false>() && !eliminate<true>())
      return false;
    double finite = 0;  // NaN when any entry is not finite
    for (const double entry : inverse_) finite += entry * 0.0;
    return finite == 0;
  }

  /// Overwrites x (N entries) by the solution.
  void solve(double* x) const {
    std::array<double, N> sum{};
    // Column by column: N independent sums, one multiply-add per column.
    for (std::size_t j = 0; j < N; ++j)
      for (std::size_t i = 0; i < N; ++i) sum[i] += columns(i, j) * x[j];
    for (std::size_t i = 0; i < N; ++i) x[i] = sum[i];
  }

 private:
  double a(std::size_t i, std::size_t j) const { return a_[i * N + j]; }
  /// Entry (i, j) of the inverse; stored column by column.
  double columns(std::size_t i, std::size_t j) const { return inverse_[j * N + i]; }

  void invert_by_cofactors() {
    if constexpr (N == 2) {
      const double d = 1 / (a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0));
      inverse_ = {a(1, 1) * d, -a(1, 0) * d, -a(0, 1) * d, a(0, 0) * d};
    } else if constexpr (N == 3) {
      const double c00 = a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1);
      const double c01 = a(1, 2) * a(2, 0) - a(1, 0) * a(2, 2);
      const double c02 = a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0);
      const double d = 1 / (a(0, 0) * c00 + a(0, 1) * c01 + a(0, 2) * c02);
      inverse_ = {c00 * d,
                  c01 * d,
                  c02 * d,
                  (a(0, 2) * a(2, 1) - a(0, 1) * a(2, 2)) * d,
                  (a(0, 0) * a(2, 2) - a(0, 2) * a(2, 0)) * d,
                  (a(0, 1) * a(2, 0) - a(0, 0) * a(2, 1)) * d,
                  (a(0, 1) * a(1, 2) - a(0, 2) * a(1, 1)) * d,
                  (a(0, 2) * a(1, 0) - a(0, 0) * a(1, 2)) * d,
                  (a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0)) * d};
    }
  }

  /// Gauss-Jordan elimination in place, on the transposed matrix, so that the result is stored
  /// column by column. Without pivoting; false where a multiplier is large.
  template <bool pivoting>
  bool eliminate() {
    constexpr double largest_multiplier = 100;  // at most two digits lost per elimination step
    std::array<double, N* N>& m = inverse_;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) m[i * N + j] = a(j, i);
    std::array<std::size_t, N> swapped{};
    std::array<double, N> factor{}, row{};
    for (std::size_t k = 0; k < N; ++k) {
      if constexpr (pivoting) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < N; ++i)
          if (std::abs(m[i * N + k]) > std::abs(m[pivot * N + k])) pivot = i;
        swapped[k] = pivot;
        if (pivot != k)
          for (std::size_t j = 0; j < N; ++j) std::swap(m[k * N + j], m[pivot * N + j]);
        if (m[k * N + k] == 0) return false;
      }
      const double reciprocal = 1 / m[k * N + k];
      double worst = 0;
      for (std::size_t i = 0; i < N; ++i) {
        factor[i] = m[i * N + k];
        m[i * N + k] = 0;
        if (i > k) worst = std::max(worst, std::abs(factor[i]));
      }
      if constexpr (!pivoting)
        if (!(worst * std::abs(reciprocal) < largest_multiplier)) return false;
      for (std::size_t j = 0; j < N; ++j) row[j] = m[k * N + j] * reciprocal;
      row[k] = reciprocal;
      for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) m[i * N + j] -= factor[i] * row[j];
      for (std::size_t j = 0; j < N; ++j) m[k * N + j] = row[j];
    }
    if constexpr (pivoting)
      for (std::size_t k = N; k-- > 0;)
        if (swapped[k] != k)
          for (std::size_t i = 0; i < N; ++i) std::swap(m[i * N + k], m[i * N + swapped[k]]);
    return true;
  }

  std::array<double, N * N> a_{}, inverse_{};
};

/// Up to this many unknowns the inverse is faster than a triangular solve.
inline constexpr std::size_t small_inverse_limit = 16;

/// The dense solver for a problem's dimension, made for its size at run time.
template <std::size_t N>
using DenseSolver =
    std::conditional_t<(N <= small_inverse_limit),
                       SmallInverse<(N <= small_inverse_limit ? N : std::size_t{1})>, DenseLu>;

}  // namespace odeum::linear
