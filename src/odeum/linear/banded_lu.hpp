// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace odeum::linear {

/// LU factorisation with partial pivoting of a real or complex band matrix (Golub and Van Loan,
/// Matrix Computations, 4.3), by rows. Real and imaginary parts are stored apart, so that compilers
/// vectorise the loops over a row.
template <bool is_complex, class Real = double>
class BandedLu {
 public:
  /// n >= 1 rows; entries at most `lower` below and `upper` above the diagonal.
  BandedLu(std::size_t n, std::size_t lower, std::size_t upper)
      : n_(n),
        lower_(lower),
        upper_(upper),
        width_(2 * lower + upper + 1),
        re_(n * width_),
        im_(is_complex ? n * width_ : 0),
        factor_re_(n * lower),
        factor_im_(is_complex ? n * lower : 0),
        pivot_(n),
        last_(n) {}

  void clear() {
    std::fill(re_.begin(), re_.end(), Real(0));
    std::fill(im_.begin(), im_.end(), Real(0));
  }
  /// The index of entry (row, column) of the band in re() and im().
  std::size_t place(std::size_t row, std::size_t column) const {
    return row * width_ + lower_ + column - row;
  }
  Real* re() { return re_.data(); }
  Real* im() { return im_.data(); }

  /// Factorises in place; false where the matrix is singular or has an entry that is not finite.
  bool factorise() {
    std::size_t last = 0;  // the last column that is not zero in a row with a pivot so far
    for (std::size_t k = 0; k < n_; ++k) {
      const std::size_t below = std::min(lower_, n_ - 1 - k);
      std::size_t pivot = k;
      Real largest = size(place(k, k));
      for (std::size_t i = k + 1; i <= k + below; ++i)
        if (const Real candidate = size(place(i, k)); candidate > largest)
          pivot = i, largest = candidate;
      if (!(largest > 0) || !std::isfinite(largest)) return false;
      last = std::max(last, std::min(pivot + upper_, n_ - 1));
      pivot_[k] = pivot;
      last_[k] = last;
      if (pivot != k) swap_rows(k, pivot, last);
      invert(place(k, k));
      for (std::size_t i = k + 1; i <= k + below; ++i) eliminate(i, k, last);
    }
    return true;
  }

  /// Overwrites (re, im) by the solution; `im` is not read where the matrix is real.
  void solve(Real* re, Real* im) const {
    for (std::size_t k = 0; k < n_; ++k) {
      const std::size_t below = std::min(lower_, n_ - 1 - k);
      if (pivot_[k] != k) {
        std::swap(re[k], re[pivot_[k]]);
        if constexpr (is_complex) std::swap(im[k], im[pivot_[k]]);
      }
      for (std::size_t i = 0; i < below; ++i) {
        const std::size_t at = k * lower_ + i, to = k + 1 + i;
        re[to] -= factor_re_[at] * re[k];
        if constexpr (is_complex) {
          re[to] += factor_im_[at] * im[k];
          im[to] -= factor_re_[at] * im[k] + factor_im_[at] * re[k];
        }
      }
    }
    for (std::size_t k = n_; k-- > 0;) {
      Real sum_re = re[k], sum_im = 0;
      if constexpr (is_complex) sum_im = im[k];
      const std::size_t row = place(k, k);
      for (std::size_t j = 1; j <= last_[k] - k; ++j) {
        sum_re -= re_[row + j] * re[k + j];
        if constexpr (is_complex) {
          sum_re += im_[row + j] * im[k + j];
          sum_im -= re_[row + j] * im[k + j] + im_[row + j] * re[k + j];
        }
      }
      if constexpr (is_complex) {
        re[k] = re_[row] * sum_re - im_[row] * sum_im;
        im[k] = re_[row] * sum_im + im_[row] * sum_re;
      } else {
        re[k] = re_[row] * sum_re;
      }
    }
  }

 private:
  Real size(std::size_t at) const {
    if constexpr (is_complex) return std::abs(re_[at]) + std::abs(im_[at]);
    return std::abs(re_[at]);
  }
  void swap_rows(std::size_t a, std::size_t b, std::size_t last) {
    const std::size_t from_a = place(a, a), from_b = place(b, a), count = last - a + 1;
    std::swap_ranges(re() + from_a, re() + from_a + count, re() + from_b);
    if constexpr (is_complex) std::swap_ranges(im() + from_a, im() + from_a + count, im() + from_b);
  }
  void invert(std::size_t at) {
    if constexpr (is_complex) {
      const Real square = re_[at] * re_[at] + im_[at] * im_[at];
      re_[at] /= square;
      im_[at] /= -square;
    } else {
      re_[at] = 1 / re_[at];
    }
  }
  /// Row i minus its factor times row k, whose diagonal holds the inverse of the pivot.
  void eliminate(std::size_t i, std::size_t k, std::size_t last) {
    const std::size_t pivot = place(k, k), row = place(i, k), count = last - k;
    const Real inverse_re = re_[pivot], entry_re = re_[row];
    const std::size_t at = k * lower_ + (i - k - 1);
    if constexpr (is_complex) {
      const Real inverse_im = im_[pivot], entry_im = im_[row];
      const Real f = entry_re * inverse_re - entry_im * inverse_im;
      const Real g = entry_re * inverse_im + entry_im * inverse_re;
      factor_re_[at] = f;
      factor_im_[at] = g;
      if (f == 0 && g == 0) return;
      for (std::size_t j = 1; j <= count; ++j) {
        re_[row + j] -= f * re_[pivot + j] - g * im_[pivot + j];
        im_[row + j] -= f * im_[pivot + j] + g * re_[pivot + j];
      }
    } else {
      const Real f = factor_re_[at] = entry_re * inverse_re;
      if (f == 0) return;
      for (std::size_t j = 1; j <= count; ++j) re_[row + j] -= f * re_[pivot + j];
    }
  }

  std::size_t n_, lower_, upper_, width_;
  std::vector<Real> re_, im_;                // U, with room for rows that are swapped
  std::vector<Real> factor_re_, factor_im_;  // L, `lower` for each column
  std::vector<std::size_t> pivot_, last_;
};

}  // namespace odeum::linear
