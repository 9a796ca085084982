// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/sparse_system.hpp"

#include <Eigen/SparseLU>
#include <stdexcept>
#include <utility>

#include "odeum/linear/banded_lu.hpp"
#include "odeum/linear/ordering.hpp"

namespace odeum {
namespace {

using Complex = std::complex<double>;
using linear::Band;

/// The factors of one I - g J.
class Factors {
 public:
  virtual ~Factors() = default;
  /// `values`: of the pattern's entries.
  virtual bool factorise(const std::vector<double>& values, Complex g) = 0;
  virtual void solve(double* re, double* im) = 0;
};

/// Multiplications per unknown of a factorisation without exchanges of rows.
double work_of(const Band& band) {
  return static_cast<double>((band.lower + 1) * (band.upper + 1));
}

/// The better of the given and the reverse Cuthill-McKee ordering.
Band narrow_band(const Sparsity& pattern) {
  Band as_given = linear::band_of(pattern);
  if (work_of(as_given) <= 9) return as_given;  // tridiagonal, or nearly
  Band ordered = linear::band_of(pattern, linear::reverse_cuthill_mckee(pattern));
  return work_of(ordered) < work_of(as_given) ? ordered : as_given;
}

template <bool is_complex>
class BandFactors final : public Factors {
 public:
  BandFactors(const Sparsity& pattern, const Band& band)
      : n_(pattern.unknowns()),
        order_(band.order),
        lu_(n_, band.lower, band.upper),
        x_re_(n_),
        x_im_(is_complex ? n_ : 0) {
    const auto place = [&](int row, int column) {
      return lu_.place(static_cast<std::size_t>(band.number[row]),
                       static_cast<std::size_t>(band.number[column]));
    };
    for (std::size_t i = 0; i < n_; ++i) {
      diagonal_.push_back(place(static_cast<int>(i), static_cast<int>(i)));
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        places_.push_back(place(static_cast<int>(i), pattern.column[k]));
    }
  }
  bool factorise(const std::vector<double>& values, Complex g) override {
    lu_.clear();
    double *const re = lu_.re(), *const im = lu_.im();
    for (std::size_t k = 0; k < values.size(); ++k) {
      re[places_[k]] = -g.real() * values[k];
      if constexpr (is_complex) im[places_[k]] = -g.imag() * values[k];
    }
    for (const std::size_t at : diagonal_) re[at] += 1;
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
  linear::BandedLu<is_complex> lu_;
  std::vector<std::size_t> places_, diagonal_;
  std::vector<double> x_re_, x_im_;
};

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
  bool factorise(const std::vector<double>& values, Complex g) override {
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
  static constexpr bool is_complex = std::is_same_v<Scalar, Complex>;
  static Scalar scaled(Complex g, double value) {
    if constexpr (is_complex) return -g * value;
    return -g.real() * value;
  }
  Eigen::SparseMatrix<Scalar, Eigen::ColMajor, int> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<Scalar, Eigen::ColMajor, int>, Eigen::COLAMDOrdering<int>>
      lu_;
  std::vector<std::size_t> places_, diagonal_;
};

void require_pattern(const Sparsity& pattern) {
  const auto n = static_cast<int>(pattern.unknowns());
  bool sound = n > 0 && pattern.start[0] == 0 &&
               pattern.start.back() == static_cast<int>(pattern.column.size());
  for (int i = 0; i < n && sound; ++i) {
    sound = pattern.start[i] <= pattern.start[i + 1];
    for (int k = pattern.start[i]; k < pattern.start[i + 1] && sound; ++k)
      sound = pattern.column[k] >= 0 && pattern.column[k] < n &&
              (k == pattern.start[i] || pattern.column[k] > pattern.column[k - 1]);
  }
  if (!sound)
    throw std::invalid_argument(
        "sparsity: each row's columns must rise and lie below the number of unknowns");
}

/// A band is factorised at two to three multiplications a nanosecond, Eigen's sparse LU takes some
/// 0.3 us an unknown and 10 ns for each entry of its factors.
constexpr double most_band_work = 2000;

}  // namespace

struct SparseSystem::Parts {
  const Sparsity& pattern;
  JacobianEntries entries;
  Band band;
  bool is_band;
  std::vector<double> values, y;
  double t = 0;
  bool linearised = false, finite = false;
  std::vector<std::unique_ptr<Factors>> real, complex;  // by shift; made when first needed

  Parts(const Sparsity& s, JacobianEntries e, std::size_t shifts)
      : pattern(s),
        entries(std::move(e)),
        band(narrow_band(s)),
        is_band(work_of(band) <= most_band_work),
        values(s.entries()),
        y(s.unknowns()),
        real(shifts),
        complex(shifts) {}

  std::unique_ptr<Factors>& factors(std::size_t shift, bool is_complex) {
    std::unique_ptr<Factors>& of = (is_complex ? complex : real)[shift];
    if (of) return of;
    if (is_band && is_complex)
      of = std::make_unique<BandFactors<true>>(pattern, band);
    else if (is_band)
      of = std::make_unique<BandFactors<false>>(pattern, band);
    else if (is_complex)
      of = std::make_unique<SparseFactors<Complex>>(pattern);
    else
      of = std::make_unique<SparseFactors<double>>(pattern);
    return of;
  }
};

SparseSystem::SparseSystem(const Sparsity& pattern, JacobianEntries entries, std::size_t shifts) {
  require_pattern(pattern);
  parts_ = std::make_unique<Parts>(pattern, std::move(entries), shifts);
}
SparseSystem::~SparseSystem() = default;

void SparseSystem::linearise(double t, const double* y) {
  Parts& p = *parts_;
  if (p.linearised && t == p.t && std::equal(p.y.begin(), p.y.end(), y)) return;
  p.entries(t, y, p.values.data());
  p.t = t;
  std::copy(y, y + p.y.size(), p.y.begin());
  double finite = 0;  // NaN when any value is not finite
  for (const double value : p.values) finite += value * 0.0;
  p.finite = finite == 0;
  p.linearised = true;
}

bool SparseSystem::factorise(std::size_t shift, std::complex<double> g) {
  Parts& p = *parts_;
  return p.finite && p.factors(shift, g.imag() != 0)->factorise(p.values, g);
}

void SparseSystem::solve(std::size_t shift, double* re, double* im) {
  parts_->factors(shift, im != nullptr)->solve(re, im);
}

std::string SparseSystem::method() const {
  const Band& band = parts_->band;
  if (!parts_->is_band) return "sparse LU";
  return "LU of a band of " + std::to_string(band.lower) + " below and " +
         std::to_string(band.upper) + " above the diagonal";
}

namespace {

class SparseShiftedSolver final : public ShiftedSolver {
 public:
  SparseShiftedSolver(const Sparsity& pattern, JacobianEntries entries)
      : system_(pattern, std::move(entries), 1) {}
  bool factorise(double t, const double* y, double gamma_h) override {
    system_.linearise(t, y);
    return system_.factorise(0, gamma_h);
  }
  bool solve(double* x, double) override {
    system_.solve(0, x, nullptr);
    return true;
  }

 private:
  SparseSystem system_;
};

}  // namespace

std::unique_ptr<ShiftedSolver> make_sparse_solver(const Sparsity& pattern,
                                                  JacobianEntries entries) {
  return std::make_unique<SparseShiftedSolver>(pattern, std::move(entries));
}

}  // namespace odeum
