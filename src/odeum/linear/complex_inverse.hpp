// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

#include "odeum/linear/square_matrix.hpp"

namespace odeum::linear {

/// The inverse of the complex matrix I - g J, J real and row-major of n x n entries, N of them
/// known at compile time or `dynamic`. Real and imaginary parts are stored apart: compilers
/// vectorise plain loops over them, not those over std::complex.
template <std::size_t N>
class ComplexInverse {
 public:
  explicit ComplexInverse(std::size_t n)
      : n_(n), re_(make_square<N>(n)), im_(re_), row_re_(make_row<N>(n)), row_im_(row_re_) {}

  /// False where the matrix is singular or has an entry that is not finite.
  bool factorise(std::complex<double> g, const double* j) {
    if (!eliminate<false>(g, j) && !eliminate<true>(g, j)) return false;
    double finite = 0;
    for (std::size_t i = 0; i < size() * size(); ++i) finite += re_[i] * 0.0 + im_[i] * 0.0;
    return finite == 0;
  }

  /// Overwrites (re, im), n entries each, by the solution.
  void solve(double* re, double* im) {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) row_re_[i] = row_im_[i] = 0;
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {  // stored column by column
        row_re_[i] += re_[j * n + i] * re[j] - im_[j * n + i] * im[j];
        row_im_[i] += re_[j * n + i] * im[j] + im_[j * n + i] * re[j];
      }
    for (std::size_t i = 0; i < n; ++i) {
      re[i] = row_re_[i];
      im[i] = row_im_[i];
    }
  }

 private:
  constexpr std::size_t size() const { return N == dynamic ? n_ : N; }
  double modulus(std::size_t at) const { return std::abs(re_[at]) + std::abs(im_[at]); }

  /// Gauss-Jordan elimination in place, on the transposed matrix. Without pivoting; false where a
  /// multiplier is large.
  template <bool pivoting>
  bool eliminate(std::complex<double> g, const double* jacobian) {
    constexpr double largest_multiplier = 100;
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        re_[i * n + j] = (i == j ? 1 : 0) - g.real() * jacobian[j * n + i];
        im_[i * n + j] = -g.imag() * jacobian[j * n + i];
      }
    auto swapped = make_row<N, std::size_t>(n);
    for (std::size_t k = 0; k < n; ++k) {
      if constexpr (pivoting) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
          if (modulus(i * n + k) > modulus(pivot * n + k)) pivot = i;
        swapped[k] = pivot;
        if (pivot != k)
          for (std::size_t j = 0; j < n; ++j) {
            std::swap(re_[k * n + j], re_[pivot * n + j]);
            std::swap(im_[k * n + j], im_[pivot * n + j]);
          }
      }
      const double p_re = re_[k * n + k], p_im = im_[k * n + k];
      const double square = p_re * p_re + p_im * p_im;
      if (!(square > 0)) return false;
      const double q_re = p_re / square, q_im = -p_im / square;
      re_[k * n + k] = 1;
      im_[k * n + k] = 0;
      for (std::size_t j = 0; j < n; ++j) {
        const double x = re_[k * n + j], y = im_[k * n + j];
        row_re_[j] = x * q_re - y * q_im;
        row_im_[j] = x * q_im + y * q_re;
      }
      double worst = 0;
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k) continue;
        const double f_re = re_[i * n + k], f_im = im_[i * n + k];
        if (i > k) worst = std::max(worst, f_re * f_re + f_im * f_im);
        re_[i * n + k] = im_[i * n + k] = 0;
        for (std::size_t j = 0; j < n; ++j) {
          re_[i * n + j] -= f_re * row_re_[j] - f_im * row_im_[j];
          im_[i * n + j] -= f_re * row_im_[j] + f_im * row_re_[j];
        }
      }
      if constexpr (!pivoting)
        if (!(worst < largest_multiplier * largest_multiplier * square)) return false;
      for (std::size_t j = 0; j < n; ++j) {
        re_[k * n + j] = row_re_[j];
        im_[k * n + j] = row_im_[j];
      }
    }
    if constexpr (pivoting)
      for (std::size_t k = n; k-- > 0;)
        if (swapped[k] != k)
          for (std::size_t i = 0; i < n; ++i) {
            std::swap(re_[i * n + k], re_[i * n + swapped[k]]);
            std::swap(im_[i * n + k], im_[i * n + swapped[k]]);
          }
    return true;
  }

  std::size_t n_;
  Square<N> re_, im_;
  RowOf<N> row_re_, row_im_;
};

}  // namespace odeum::linear
