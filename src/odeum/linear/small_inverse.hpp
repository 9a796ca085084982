// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "odeum/core/lanes.hpp"
#include "odeum/linear/dense_lu.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum::linear {

/// A vector of that many numbers, which fits into a register. g++ 12 takes no size that depends on
/// a parameter, and moves the parts of larger vectors through memory, number by number.
template <std::size_t>
struct RegisterOf;
template <>
struct RegisterOf<2> {
  using type [[gnu::vector_size(2 * 8)]] = double;
  using mask [[gnu::vector_size(2 * 8)]] = std::int64_t;
  static constexpr mask places{0, 1};
};
template <>
struct RegisterOf<4> {
  using type [[gnu::vector_size(4 * 8)]] = double;
  using mask [[gnu::vector_size(4 * 8)]] = std::int64_t;
  static constexpr mask places{0, 1, 2, 3};
};
template <>
struct RegisterOf<8> {
  using type [[gnu::vector_size(8 * 8)]] = double;
  using mask [[gnu::vector_size(8 * 8)]] = std::int64_t;
  static constexpr mask places{0, 1, 2, 3, 4, 5, 6, 7};
};

/// The inverse of a row-major N x N matrix, N small and known at compile time: a solve by
/// multiplication has no chain of dependent operations, unlike a triangular solve, which repays the
/// more expensive factorisation after two or three solves. Same interface as DenseLu. Up to 3 x 3
/// for any type of numbers.
template <std::size_t N, class Real = double>
class SmallInverse {
 public:
  /// The argument is that of DenseLu.
  explicit SmallInverse(std::size_t /*n*/ = N) {}
  /// The N x N entries: fill them, then call factorise().
  Real* data() { return a_.data(); }

  /// False where the matrix is singular or has an entry that is not finite.
  bool factorise() {
    if constexpr (N == 1)
      inverse_[0] = 1 / a_[0];
    else if constexpr (N <= 3)
      invert_by_cofactors();
    else if (!eliminate<false>() && !eliminate<true>())
      return false;
    Real finite = 0;  // NaN when any entry is not finite
    for (const Real& entry : inverse_) finite += entry * 0.0;
    Part rest{};
    for (const Row& row : m_)
      for (const Part& part : row) rest += part * 0.0;
    for (std::size_t i = 0; i < numbers; ++i) finite += rest[i];
    return finite == 0;
  }

  /// Overwrites x (N entries) by the solution.
  void solve(Real* x) const {
    if constexpr (N <= 3) {
      std::array<Real, N> sum{};
      for (std::size_t j = 0; j < N; ++j)
        for (std::size_t i = 0; i < N; ++i) sum[i] += inverse_[j * N + i] * x[j];
      for (std::size_t i = 0; i < N; ++i) x[i] = sum[i];
    } else {
      // Column by column: N independent sums, one multiply-add per column.
      Row sum;
      for (std::size_t p = 0; p < parts; ++p) sum[p] = m_[0][p] * x[0];
      for (std::size_t j = 1; j < N; ++j)
        for (std::size_t p = 0; p < parts; ++p) sum[p] += m_[j][p] * x[j];
      for (std::size_t i = 0; i < N; ++i) x[i] = sum[i / numbers][i % numbers];
    }
  }

 private:
  Real a(std::size_t i, std::size_t j) const { return a_[i * N + j]; }

  void invert_by_cofactors() {
    if constexpr (N == 2) {
      const Real d = 1 / (a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0));
      inverse_ = {a(1, 1) * d, -a(1, 0) * d, -a(0, 1) * d, a(0, 0) * d};
    } else if constexpr (N == 3) {
      const Real c00 = a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1);
      const Real c01 = a(1, 2) * a(2, 0) - a(1, 0) * a(2, 2);
      const Real c02 = a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0);
      const Real d = 1 / (a(0, 0) * c00 + a(0, 1) * c01 + a(0, 2) * c02);
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
  /// column by column. Without pivoting; false where a multiplier is large. A row is loaded and
  /// stored as a whole: one that had an entry stored alone could not be forwarded to the next load.
  template <bool pivoting>
  bool eliminate() {
    constexpr double largest_multiplier = 100;  // at most two digits lost per elimination step
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) entry(i, j) = a(j, i);
    if constexpr (pivoting) {
      std::array<std::size_t, N> swapped{};
      for (std::size_t k = 0; k < N; ++k) {
        swapped[k] = k;
        for (std::size_t i = k + 1; i < N; ++i)
          if (std::abs(entry(i, k)) > std::abs(entry(swapped[k], k))) swapped[k] = i;
        std::swap(m_[k], m_[swapped[k]]);
        if (entry(k, k) == 0) return false;
        eliminate_column(k);
      }
      for (std::size_t k = N; k-- > 0;)
        if (swapped[k] != k)
          for (std::size_t i = 0; i < N; ++i) {
            const double kept = entry(i, k);
            entry(i, k) = entry(i, swapped[k]);
            entry(i, swapped[k]) = kept;
          }
    } else {
#pragma GCC unroll 16  // halves the time, since places in registers are then known
      for (std::size_t k = 0; k < N; ++k) {
        double worst = 0;
        for (std::size_t i = k + 1; i < N; ++i) worst = std::max(worst, std::abs(entry(i, k)));
        if (!(worst < largest_multiplier * std::abs(entry(k, k)))) return false;
        eliminate_column(k);
      }
    }
    return true;
  }

  [[gnu::always_inline]] void eliminate_column(std::size_t k) {
    const double reciprocal = 1 / entry(k, k);
    const std::size_t own = k / numbers;  // the part with column k
    const Mask others = RegisterOf<numbers>::places != static_cast<std::int64_t>(k % numbers);
    Row row = m_[k];
    for (Part& part : row) part *= reciprocal;
    row[own] = others ? row[own] : Part{} + reciprocal;
    for (std::size_t i = 0; i < N; ++i) {
      if (i == k) continue;
      const double multiplier = entry(i, k);
      m_[i][own] = others ? m_[i][own] : Part{};
      for (std::size_t p = 0; p < parts; ++p) m_[i][p] -= multiplier * row[p];
    }
    m_[k] = row;
  }

  /// The numbers of a register, and the registers of a row, which has zeros behind its entries.
  static constexpr std::size_t numbers =
      std::min(vector_bytes / sizeof(double), std::bit_ceil(std::max(N, std::size_t{2})));
  static constexpr std::size_t parts = (N + numbers - 1) / numbers;
  using Part = typename RegisterOf<numbers>::type;
  using Mask = typename RegisterOf<numbers>::mask;
  using Row = std::array<Part, parts>;
  double& entry(std::size_t i, std::size_t j) { return reinterpret_cast<double*>(&m_[i])[j]; }
  std::array<Real, N * N> a_{};
  std::array<Real, (N <= 3 ? N * N : 0)> inverse_{};  ///< column by column, as the rows below
  std::array<Row, (N <= 3 ? 0 : N)> m_{};
};

/// Up to this many unknowns the inverse is faster than a triangular solve.
inline constexpr std::size_t small_inverse_limit = 16;

/// The dense solver for a problem's dimension, made for its size at run time.
template <std::size_t N>
using DenseSolver =
    std::conditional_t<(N <= small_inverse_limit),
                       SmallInverse<(N <= small_inverse_limit ? N : std::size_t{1})>, DenseLu>;

}  // namespace odeum::linear
