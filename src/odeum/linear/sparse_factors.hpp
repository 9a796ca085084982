// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The factors that sparse_system.cpp chooses from.
#include <Eigen/SparseLU>
#include <algorithm>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "odeum/linear/banded_lu.hpp"
#include "odeum/linear/narrow_lu.hpp"
#include "odeum/linear/ordering.hpp"
#include "odeum/linear/pattern_lu.hpp"

namespace odeum::linear {

/// The factors of one I - g J.
class Factors {
 public:
  virtual ~Factors() = default;
  /// `values`: of the pattern's entries.
  virtual bool factorise(const std::vector<double>& values, std::complex<double> g) = 0;
  virtual void solve(double* re, double* im) = 0;
};

/// The indices of the entries of I - g J among the numbers of an LU of a band.
template <bool is_complex>
class BandPlaces {
 public:
  template <class Lu>
  BandPlaces(const Lu& lu, const Sparsity& pattern, const Band& band) {
    const auto place = [&](std::size_t row, std::size_t column) {
      return lu.place(static_cast<std::size_t>(band.number[row]),
                      static_cast<std::size_t>(band.number[column]));
    };
    for (std::size_t i = 0; i < pattern.unknowns(); ++i) {
      diagonal_.push_back(place(i, i));
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        entries_.push_back(place(i, static_cast<std::size_t>(pattern.column[k])));
    }
  }
  template <class Lu>
  void fill(Lu& lu, const std::vector<double>& values, std::complex<double> g) const {
    lu.clear();
    double *const re = lu.re(), *const im = lu.im();
    for (std::size_t k = 0; k < values.size(); ++k) {
      re[entries_[k]] = -g.real() * values[k];
      if constexpr (is_complex) im[entries_[k]] = -g.imag() * values[k];
    }
    for (const std::size_t at : diagonal_) re[at] += 1;
  }

 private:
  std::vector<std::size_t> entries_, diagonal_;
};

template <bool is_complex>
class BandFactors final : public Factors {
 public:
  BandFactors(const Sparsity& pattern, const Band& band)
      : n_(pattern.unknowns()),
        order_(band.order),
        lu_(n_, band.lower, band.upper),
        places_(lu_, pattern, band),
        x_re_(n_),
        x_im_(is_complex ? n_ : 0) {}
  bool factorise(const std::vector<double>& values, std::complex<double> g) override {
    places_.fill(lu_, values, g);
    return lu_.factorise();
  }
  void solve(double* re, double* im) override {
    for (std::size_t k = 0; k < n_; ++k) {
      x_re_[k] = re[order_[k]];
      if constexpr (is_complex) x_im_[k] = im[order_[k]];
    }
    lu_.solve(x_re_.data(), x_im_.data());
    for (std::size_t k = 0; k < n_; ++k) {
      re[order_[k]] = x_re_[k];
      if constexpr (is_complex) im[order_[k]] = x_im_[k];
    }
  }

 private:
  std::size_t n_;
  std::vector<int> order_;
  BandedLu<is_complex> lu_;
  BandPlaces<is_complex> places_;
  std::vector<double> x_re_, x_im_;
};

/// Factors of at most `width` entries below and above the diagonal; uses BandFactors where rows
/// have to be exchanged.
template <bool is_complex, std::size_t width>
class NarrowFactors final : public Factors {
 public:
  NarrowFactors(const Sparsity& pattern, const Band& band)
      : pattern_(pattern), band_(band), lu_(pattern.unknowns()), places_(lu_, pattern, band) {}
  bool factorise(const std::vector<double>& values, std::complex<double> g) override {
    places_.fill(lu_, values, g);
    exchanged_ = !lu_.factorise();
    if (!exchanged_) return true;
    if (!with_exchanges_) with_exchanges_.emplace(pattern_, band_);
    return with_exchanges_->factorise(values, g);
  }
  void solve(double* re, double* im) override {
    if (exchanged_) return with_exchanges_->solve(re, im);
    lu_.solve(re, im, band_.order.data());
  }

 private:
  const Sparsity& pattern_;
  const Band& band_;
  NarrowLu<is_complex, width> lu_;
  BandPlaces<is_complex> places_;
  bool exchanged_ = false;
  std::optional<BandFactors<is_complex>> with_exchanges_;
};

/// Factors of the least width that holds the band.
template <bool is_complex>
std::unique_ptr<Factors> band_factors(const Sparsity& pattern, const Band& band) {
  const std::size_t width = std::max(band.lower, band.upper);
  if (width > 3 || pattern.unknowns() < 12)
    return std::make_unique<BandFactors<is_complex>>(pattern, band);
  if (width <= 1) return std::make_unique<NarrowFactors<is_complex, 1>>(pattern, band);
  if (width == 2) return std::make_unique<NarrowFactors<is_complex, 2>>(pattern, band);
  return std::make_unique<NarrowFactors<is_complex, 3>>(pattern, band);
}

template <class Scalar>
class SparseFactors final : public Factors {
 public:
  explicit SparseFactors(const Sparsity& pattern)
      : matrix_(static_cast<Eigen::Index>(pattern.unknowns()),
                static_cast<Eigen::Index>(pattern.unknowns())) {
    std::vector<Eigen::Triplet<Scalar, int>> triplets;
    const auto n = static_cast<int>(pattern.unknowns());
    for (int i = 0; i < n; ++i) {
      triplets.emplace_back(i, i, Scalar(1));
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        triplets.emplace_back(i, pattern.column[k], Scalar(1));
    }
    matrix_.setFromTriplets(triplets.begin(), triplets.end());
    matrix_.makeCompressed();
    const auto place = [&](int row, int column) {
      const int* const rows = matrix_.innerIndexPtr();
      const int *const first = rows + matrix_.outerIndexPtr()[column],
                       *const last = rows + matrix_.outerIndexPtr()[column + 1];
      return static_cast<std::size_t>(std::lower_bound(first, last, row) - rows);
    };
    for (int i = 0; i < n; ++i) {
      diagonal_.push_back(place(i, i));
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        places_.push_back(place(i, pattern.column[k]));
    }
    lu_.analyzePattern(matrix_);
  }
  bool factorise(const std::vector<double>& values, std::complex<double> g) override {
    Scalar* const entries = matrix_.valuePtr();
    std::fill(entries, entries + matrix_.nonZeros(), Scalar(0));
    for (std::size_t k = 0; k < values.size(); ++k) entries[places_[k]] = scaled(g, values[k]);
    for (const std::size_t at : diagonal_) entries[at] += 1;
    lu_.factorize(matrix_);
    return lu_.info() == Eigen::Success;
  }
  void solve(double* re, double* im) override {
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> right(matrix_.rows());
    for (Eigen::Index k = 0; k < matrix_.rows(); ++k) {
      if constexpr (is_complex)
        right[k] = {re[k], im[k]};
      else
        right[k] = re[k];
    }
    right = lu_.solve(right).eval();
    for (Eigen::Index k = 0; k < matrix_.rows(); ++k) {
      re[k] = std::real(right[k]);
      if constexpr (is_complex) im[k] = std::imag(right[k]);
    }
  }

 private:
  static constexpr bool is_complex = !std::is_arithmetic_v<Scalar>;
  static Scalar scaled(std::complex<double> g, double value) {
    if constexpr (is_complex) return -g * value;
    return -g.real() * value;
  }
  Eigen::SparseMatrix<Scalar, Eigen::ColMajor, int> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<Scalar, Eigen::ColMajor, int>, Eigen::COLAMDOrdering<int>>
      lu_;
  std::vector<std::size_t> places_, diagonal_;
};

/// Factors by a list of eliminations, and with exchanges of rows where these are needed.
template <class Scalar>
class FewFactors final : public Factors {
 public:
  FewFactors(const Sparsity& pattern, const std::shared_ptr<const Elimination>& how)
      : pattern_(pattern), lu_(pattern, how), x_(is_complex ? pattern.unknowns() : 0) {}
  bool factorise(const std::vector<double>& values, std::complex<double> g) override {
    Scalar shift = 0;
    if constexpr (is_complex)
      shift = g;
    else
      shift = g.real();
    exchanged_ = !lu_.factorise(values, shift);
    if (!exchanged_) return true;
    if (pattern_.unknowns() <= Elimination::few_unknowns) return false;
    if (!with_exchanges_) with_exchanges_.emplace(pattern_);
    return with_exchanges_->factorise(values, g);
  }
  void solve(double* re, double* im) override {
    if (exchanged_) return with_exchanges_->solve(re, im);
    if constexpr (is_complex) {
      for (std::size_t k = 0; k < x_.size(); ++k) x_[k] = {re[k], im[k]};
      lu_.solve(x_.data());
      for (std::size_t k = 0; k < x_.size(); ++k) re[k] = x_[k].real(), im[k] = x_[k].imag();
    } else {
      lu_.solve(re);
    }
  }

 private:
  static constexpr bool is_complex = !std::is_arithmetic_v<Scalar>;
  const Sparsity& pattern_;
  PatternLu<Scalar> lu_;
  std::vector<Scalar> x_;
  bool exchanged_ = false;
  std::optional<SparseFactors<Scalar>> with_exchanges_;
};

}  // namespace odeum::linear
