// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "odeum/linear/dense_lu.hpp"
#include "odeum/problem/sparsity.hpp"

namespace odeum::linear {

/// Elimination with pivots on the diagonal, in the order of least fill (Markowitz, Management
/// Science 3 (1957) 255-269), as lists of places: no search, no zeros.
struct Elimination {
  static constexpr std::size_t few_unknowns = 128;    ///< of which it has a list of targets
  static constexpr std::size_t most_unknowns = 2048;  ///< of which runs in double make one
  static constexpr std::size_t largest = 4096;
  /// Throws std::length_error for more unknowns than `largest`, or more multiplications.
  explicit Elimination(const Sparsity& pattern, double most_multiplications = 1e8);

  std::vector<int> order;            ///< order[k]: the unknown that comes as number k
  std::vector<int> start, diagonal;  ///< of the rows of both factors in that order, and of pivots
  std::vector<int> column;           ///< rising in a row
  std::vector<int> places;           ///< of the pattern's entries
  std::vector<int> targets;          ///< of the multiplications, as they follow each other
  std::vector<bool> without_gaps;    ///< the columns of a row after its pivot
  double multiplications = 0;
};

/// A thread that asks for the pattern it asked for last gets the same elimination: runs of a
/// problem follow each other, and of few unknowns it takes as long as several steps. Thread-safe.
std::shared_ptr<const Elimination> elimination_of(const Sparsity& pattern);

/// Factors by it, which must outlive them.
template <class Scalar>
class ListedLu {
 public:
  explicit ListedLu(const Elimination& how)
      : how_(how), lu_(how.column.size()), inverse_(how.order.size()), x_(how.order.size()) {}

  /// Zeros, to be filled at how.places and how.diagonal before eliminate().
  Scalar* cleared() {
    for (Scalar& entry : lu_) entry = 0;
    return lu_.data();
  }

  /// False where a multiplier is large, a pivot is zero, or an entry is not finite.
  bool eliminate() {
    return x_.size() <= Elimination::few_unknowns ? eliminate_by_targets() : eliminate_by_rows();
  }

  /// Overwrites x, of all unknowns.
  void solve(Scalar* x) {
    const Elimination& e = how_;
    const std::size_t n = x_.size();
    for (std::size_t i = 0; i < n; ++i) {
      Scalar sum = x[e.order[i]];
      for (int p = e.start[i]; p < e.diagonal[i]; ++p) sum -= times(lu_[p], x_[e.column[p]]);
      x_[i] = sum;
    }
    for (std::size_t i = n; i-- > 0;) {
      Scalar sum = x_[i];
      for (int p = e.diagonal[i] + 1; p < e.start[i + 1]; ++p)
        sum -= times(lu_[p], x_[e.column[p]]);
      x[e.order[i]] = x_[i] = times(sum, inverse_[i]);
    }
  }

  /// Rows and columns are exchanged alike, so that it is that of the pivots.
  bool negative_determinant() const {
    bool negative = false;
    for (const Scalar& pivot : inverse_) negative = negative != (pivot < 0);
    return negative;
  }

 private:
  static constexpr double largest_multiplier = 100;  // at most two digits lost by an elimination
  using Norm = decltype(std::norm(Scalar()));

  /// Takes the multiplier of a row; a NaN stays.
  static void take(const Scalar& multiplier, Norm& largest) {
    if (!(std::norm(multiplier) <= largest)) largest = std::norm(multiplier);
  }

  bool eliminate_by_targets() {
    const Elimination& e = how_;
    const int* target = e.targets.data();
    Norm largest = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (int p = e.start[i]; p < e.diagonal[i]; ++p) {
        const auto k = static_cast<std::size_t>(e.column[p]);
        const Scalar multiplier = lu_[p] = times(lu_[p], inverse_[k]);
        take(multiplier, largest);
        for (int q = e.diagonal[k] + 1; q < e.start[k + 1]; ++q)
          lu_[*target++] -= times(multiplier, lu_[q]);
      }
      inverse_[i] = Scalar(1) / lu_[e.diagonal[i]];
      if (!std::isfinite(std::norm(inverse_[i]))) return false;
    }
    return largest < largest_multiplier * largest_multiplier;
  }

  /// Each row in a vector of all columns: a list of as many targets would not stay in the cache.
  bool eliminate_by_rows() {
    const Elimination& e = how_;
    Norm largest = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (int p = e.start[i]; p < e.start[i + 1]; ++p) x_[e.column[p]] = lu_[p];
      for (int p = e.start[i]; p < e.diagonal[i]; ++p) {
        const auto k = static_cast<std::size_t>(e.column[p]);
        const Scalar multiplier = x_[k] = times(x_[k], inverse_[k]);
        take(multiplier, largest);
        const int first = e.diagonal[k] + 1, count = e.start[k + 1] - first;
        const Scalar* const row = lu_.data() + first;
        const int* const columns = e.column.data() + first;
        if (e.without_gaps[k] && count > 0) {
          Scalar* const to = x_.data() + columns[0];
          for (int q = 0; q < count; ++q) to[q] -= times(multiplier, row[q]);
        } else {
          for (int q = 0; q < count; ++q) x_[columns[q]] -= times(multiplier, row[q]);
        }
      }
      for (int p = e.start[i]; p < e.start[i + 1]; ++p) lu_[p] = x_[e.column[p]];
      inverse_[i] = Scalar(1) / lu_[e.diagonal[i]];
      if (!std::isfinite(std::norm(inverse_[i]))) return false;
    }
    return largest < largest_multiplier * largest_multiplier;
  }

  /// The product without std::complex's case of numbers that are not finite.
  static Scalar times(Scalar a, Scalar b) {
    if constexpr (std::is_arithmetic_v<Scalar>)
      return a * b;
    else
      return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }

  const Elimination& how_;
  std::vector<Scalar> lu_, inverse_, x_;
};

/// Factors of I - g J, J of the pattern. Where a multiplier is large, by a dense matrix with
/// exchanges of rows, of few_unknowns at most. The pattern must outlive them.
template <class Scalar>
class PatternLu {
 public:
  PatternLu(const Sparsity& pattern, std::shared_ptr<const Elimination> how)
      : pattern_(pattern), how_(std::move(how)), listed_(*how_) {}

  /// `values`: of the entries of J. False where the matrix is singular or not finite, or has a
  /// large multiplier and too many unknowns.
  template <class Real = double>
  bool factorise(const std::vector<Real>& values, Scalar g) {
    Scalar* const lu = listed_.cleared();
    for (const int at : how_->diagonal) lu[at] = 1;
    for (std::size_t k = 0; k < values.size(); ++k) lu[how_->places[k]] -= g * values[k];
    eliminated_ = listed_.eliminate();
    return eliminated_ ||
           (pattern_.unknowns() <= Elimination::few_unknowns && factorise_dense(values, g));
  }

  /// Overwrites x, of all unknowns.
  void solve(Scalar* x) { eliminated_ ? listed_.solve(x) : dense_->solve(x); }

 private:
  template <class Real = double>
  bool factorise_dense(const std::vector<Real>& values, Scalar g) {
    const std::size_t n = pattern_.unknowns();
    if (!dense_) dense_.emplace(n);
    Scalar* const m = dense_->data();
    for (std::size_t i = 0; i < n * n; ++i) m[i] = i % (n + 1) == 0 ? 1 : 0;
    for (std::size_t i = 0; i < n; ++i)
      for (int k = pattern_.start[i]; k < pattern_.start[i + 1]; ++k)
        m[i * n + static_cast<std::size_t>(pattern_.column[k])] -= g * values[k];
    return dense_->factorise();
  }

  const Sparsity& pattern_;
  std::shared_ptr<const Elimination> how_;
  ListedLu<Scalar> listed_;
  std::optional<Lu<Scalar>> dense_;
  bool eliminated_ = false;
};

}  // namespace odeum::linear
