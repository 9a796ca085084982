// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace odeum::linear {

/// LU factorisation with partial pivoting of a small dense row-major matrix, in place.
template <class Scalar>
class Lu {
 public:
  explicit Lu(std::size_t n) : n_(n), lu_(n * n), row_(n), scratch_(n) {}

  /// The n x n entries: fill them, then call factorise().
  Scalar* data() { return lu_.data(); }

  /// False where the matrix is singular or has an entry that is not finite.
  bool factorise() {
    // NaN when any entry is not finite: elimination may not read them all.
    decltype(std::abs(Scalar())) finite = 0;
    for (const Scalar& entry : lu_) finite += std::abs(entry) * 0;
    if (std::isnan(finite)) return false;
    negative_ = false;
    for (std::size_t i = 0; i < n_; ++i) row_[i] = i;
    for (std::size_t k = 0; k < n_; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < n_; ++i)
        if (std::abs(at(i, k)) > std::abs(at(pivot, k))) pivot = i;
      if (!(std::abs(at(pivot, k)) > 0) || !std::isfinite(std::abs(at(pivot, k)))) return false;
      if (pivot != k) {
        for (std::size_t j = 0; j < n_; ++j) std::swap(at(k, j), at(pivot, j));
        std::swap(row_[k], row_[pivot]);
        negative_ = !negative_;
      }
      if constexpr (std::is_arithmetic_v<Scalar>)
        if (at(k, k) < 0) negative_ = !negative_;
      for (std::size_t i = k + 1; i < n_; ++i) {
        const Scalar factor = at(i, k) /= at(k, k);
        if (factor == Scalar(0)) continue;
        for (std::size_t j = k + 1; j < n_; ++j) at(i, j) -= factor * at(k, j);
      }
    }
    return true;
  }

  /// Whether the determinant of the factorised real matrix is negative.
  bool negative_determinant() const { return negative_; }

  /// Overwrites x (n entries) by the solution.
  void solve(Scalar* x) {
    for (std::size_t i = 0; i < n_; ++i) {
      Scalar sum = x[row_[i]];
      for (std::size_t j = 0; j < i; ++j) sum -= at(i, j) * scratch_[j];
      scratch_[i] = sum;
    }
    for (std::size_t i = n_; i-- > 0;) {
      Scalar sum = scratch_[i];
      for (std::size_t j = i + 1; j < n_; ++j) sum -= at(i, j) * x[j];
      x[i] = sum / at(i, i);
    }
  }

 private:
  Scalar& at(std::size_t i, std::size_t j) { return lu_[i * n_ + j]; }
  std::size_t n_;
  std::vector<Scalar> lu_;
  std::vector<std::size_t> row_;
  std::vector<Scalar> scratch_;
  bool negative_ = false;
};

using DenseLu = Lu<double>;

}  // namespace odeum::linear
