// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace odeum::linear {

/// LU factorisation with partial pivoting of the complex matrix I - g J, J real and row-major of
/// n x n entries. A third of the operations of ComplexInverse, which pays where n is known at
/// compile time. Real and imaginary parts are stored apart, as there.
class ComplexLu {
 public:
  explicit ComplexLu(std::size_t n) : n_(n), re_(n * n), im_(n * n), row_(n) {}

  /// False where the matrix is singular or has an entry that is not finite.
  bool factorise(std::complex<double> g, const double* jacobian) {
    double finite = g.real() * 0 + g.imag() * 0;
    for (std::size_t k = 0; k < n_ * n_; ++k) {
      finite += jacobian[k] * 0;
      re_[k] = (k % (n_ + 1) == 0 ? 1 : 0) - g.real() * jacobian[k];
      im_[k] = -g.imag() * jacobian[k];
    }
    if (finite != 0) return false;
    for (std::size_t k = 0; k < n_; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < n_; ++i)
        if (square(i, k) > square(pivot, k)) pivot = i;
      const double largest = square(pivot, k);
      if (!(largest > 0) || !std::isfinite(largest)) return false;
      row_[k] = pivot;
      if (pivot != k) {
        std::swap_ranges(re_.data() + k * n_, re_.data() + (k + 1) * n_, re_.data() + pivot * n_);
        std::swap_ranges(im_.data() + k * n_, im_.data() + (k + 1) * n_, im_.data() + pivot * n_);
      }
      for (std::size_t i = k + 1; i < n_; ++i) eliminate(i, k, largest);
    }
    return true;
  }

  /// Overwrites (re, im), n entries each, by the solution.
  void solve(double* re, double* im) const {
    for (std::size_t k = 0; k < n_; ++k) {
      std::swap(re[k], re[row_[k]]);
      std::swap(im[k], im[row_[k]]);
    }
    for (std::size_t i = 0; i < n_; ++i) subtract(i, 0, i, re, im);
    for (std::size_t i = n_; i-- > 0;) {
      subtract(i, i + 1, n_, re, im);
      const double p_re = re_[i * n_ + i], p_im = im_[i * n_ + i], by = square(i, i);
      const double x = re[i], y = im[i];
      re[i] = (x * p_re + y * p_im) / by;
      im[i] = (y * p_re - x * p_im) / by;
    }
  }

 private:
  double square(std::size_t i, std::size_t k) const {
    const double x = re_[i * n_ + k], y = im_[i * n_ + k];
    return x * x + y * y;
  }

  /// Takes a multiple of row k, whose pivot has the squared modulus `by`, from row i.
  void eliminate(std::size_t i, std::size_t k, double by) {
    double *const re = re_.data() + i * n_, *const im = im_.data() + i * n_;
    if (re[k] == 0 && im[k] == 0) return;
    const double *const above_re = re_.data() + k * n_, *const above_im = im_.data() + k * n_;
    const double f_re = (re[k] * above_re[k] + im[k] * above_im[k]) / by,
                 f_im = (im[k] * above_re[k] - re[k] * above_im[k]) / by;
    re[k] = f_re;
    im[k] = f_im;
    for (std::size_t j = k + 1; j < n_; ++j) {
      re[j] -= f_re * above_re[j] - f_im * above_im[j];
      im[j] -= f_re * above_im[j] + f_im * above_re[j];
    }
  }

  /// Subtracts row i of the factors, from column `from` to before `to`, times x from entry i of x.
  void subtract(std::size_t i, std::size_t from, std::size_t to, double* re, double* im) const {
    const double *const row_re = re_.data() + i * n_, *const row_im = im_.data() + i * n_;
    double x = re[i], y = im[i];
    for (std::size_t j = from; j < to; ++j) {
      x -= row_re[j] * re[j] - row_im[j] * im[j];
      y -= row_re[j] * im[j] + row_im[j] * re[j];
    }
    re[i] = x;
    im[i] = y;
  }

  std::size_t n_;
  std::vector<double> re_, im_;
  std::vector<std::size_t> row_;  ///< with which row each was exchanged
};

}  // namespace odeum::linear
