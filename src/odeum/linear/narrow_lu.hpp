// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace odeum::linear {

/// LU factorisation without exchanges of rows of a matrix with `width` entries below and above the
/// diagonal, from both ends towards a block in the middle (van der Vorst, Parallel Computing 5,
/// 1987). In a solution each unknown waits for the one before; here two such chains run side by
/// side in the lanes of vectors. An object is used by one thread at a time.
template <bool is_complex, std::size_t width>
class NarrowLu {
 public:
  /// n >= 4 width unknowns.
  explicit NarrowLu(std::size_t n)
      : n_(n),
        chain_((n - width) / 2),
        size_(n - 2 * chain_),
        rows_((chain_ + width) * band),
        x_(chain_) {}

  void clear() { std::fill(rows_.begin(), rows_.end(), Pair{}); }
  /// The index of entry (row, column) of the band in re() and im(), until factorise().
  std::size_t place(std::size_t row, std::size_t column) const {
    const bool from_start = std::min(row, column) < chain_ ||
                            (row < chain_ + width && std::max(row, column) < n_ - chain_);
    if (!from_start) row = n_ - 1 - row, column = n_ - 1 - column;
    return at(row, column) * sizeof(Pair) / sizeof(double) + (from_start ? 0 : 1);
  }
  double* re() { return reinterpret_cast<double*>(rows_.data()); }
  double* im() { return re() + 2; }

  /// False where a pivot is zero, not finite or less than an entry below it, so that rows would
  /// have to be exchanged.
  bool factorise() {
    for (std::size_t k = 0; k < chain_; ++k) {
      Pair* const pivot = &rows_[at(k, k)];
      for (std::size_t i = 1; i <= width; ++i)
        if (!serves(*pivot, pivot[i * (band - 1)])) return false;
      pivot->invert();
      for (std::size_t i = 1; i <= width; ++i) {
        Pair* const row = pivot + i * (band - 1);  // row k + i from column k on
        *row = *row * *pivot;
        for (std::size_t j = 1; j <= width; ++j) row[j].subtract(*row, pivot[j]);
      }
      for (std::size_t j = 1; j <= width; ++j) pivot[j] = pivot[j] * *pivot;
    }
    middle_ = {};
    for (std::size_t i = 0; i < width; ++i)
      for (std::size_t j = 0; j < std::min(size_, i + width + 1); ++j) {
        const Pair& sum = rows_[at(chain_ + i, chain_ + j)];
        middle_[i][j] += sum.lane(0);
        middle_[size_ - 1 - i][size_ - 1 - j] += sum.lane(1);
      }
    return factorise_middle();
  }

  /// Overwrites the numbers at order[k] by the solution's number k; `im` is not read where the
  /// matrix is real.
  void solve(double* re, double* im, const int* order) {
    const int* const last = order + n_ - 1;
    std::array<Pair, width> near{};  // the newest first, which enters last
    const auto keep = [&](const Pair& x) {
      for (std::size_t i = width - 1; i > 0; --i) near[i] = near[i - 1];
      near[0] = x;
    };
    for (std::size_t k = 0; k < chain_; ++k) {
      const Pair* const pivot = &rows_[at(k, k)];
      Pair sum(get(re, im, order[k]), get(re, im, *(last - k)));
      for (std::size_t i = width; i > 0; --i) sum.subtract(*(pivot - i), near[i - 1]);
      keep(sum);
      x_[k] = sum * *pivot;
    }
    std::array<Scalar, most> x{};
    for (std::size_t i = 0; i < size_; ++i) x[i] = get(re, im, order[chain_ + i]);
    for (std::size_t i = 0; i < width; ++i) {  // rows of the middle with factors of the chains
      Pair sum;
      for (std::size_t j = 0; j < width - i; ++j)
        sum.subtract(rows_[at(chain_ + i, chain_ - 1 - j)], near[j]);
      x[i] += sum.lane(0);
      x[size_ - 1 - i] += sum.lane(1);
    }
    solve_middle(x);
    for (std::size_t i = 0; i < size_; ++i) put(re, im, order[chain_ + i], x[i]);
    for (std::size_t i = 0; i < width; ++i) near[i] = Pair(x[i], x[size_ - 1 - i]);
    for (std::size_t k = chain_; k-- > 0;) {
      const Pair* const pivot = &rows_[at(k, k)];
      Pair sum = x_[k];
      for (std::size_t j = width; j > 0; --j) sum.subtract(pivot[j], near[j - 1]);
      keep(sum);
      put(re, im, order[k], sum.lane(0));
      put(re, im, *(last - k), sum.lane(1));
    }
  }

 private:
  static constexpr std::size_t band = 2 * width + 1, most = width + 1;
  using Scalar = std::conditional_t<is_complex, std::complex<double>, double>;
  using Two [[gnu::vector_size(2 * sizeof(double))]] = double;

  /// A number of each chain.
  struct Real {
    Two re{};
    Real() = default;
    Real(Two of) : re(of) {}
    Real(double a, double b) : re{a, b} {}
    double lane(int i) const { return re[i]; }
    Real operator*(const Real& other) const { return re * other.re; }
    void subtract(const Real& a, const Real& b) { re -= a.re * b.re; }
    void invert() { re = 1 / re; }
  };
  struct Complex {
    Two re{}, im{};
    Complex() = default;
    Complex(Two x, Two y) : re(x), im(y) {}
    Complex(Scalar a, Scalar b) : re{a.real(), b.real()}, im{a.imag(), b.imag()} {}
    Scalar lane(int i) const { return {re[i], im[i]}; }
    Complex operator*(const Complex& other) const {
      return {re * other.re - im * other.im, re * other.im + im * other.re};
    }
    void subtract(const Complex& a, const Complex& b) {
      re -= a.re * b.re - a.im * b.im;
      im -= a.re * b.im + a.im * b.re;
    }
    void invert() {
      const Two square = re * re + im * im;
      re /= square;
      im /= -square;
    }
  };
  using Pair = std::conditional_t<is_complex, Complex, Real>;

  static Scalar get(const double* re, [[maybe_unused]] const double* im, int at) {
    if constexpr (is_complex)
      return {re[at], im[at]};
    else
      return re[at];
  }
  static void put(double* re, [[maybe_unused]] double* im, int at, Scalar value) {
    re[at] = std::real(value);
    if constexpr (is_complex) im[at] = value.imag();
  }
  static double size(Scalar value) {
    return std::abs(std::real(value)) + std::abs(std::imag(value));
  }
  static bool serves(Scalar pivot, Scalar other) {
    return size(pivot) >= size(other) && size(pivot) > 0 && std::isfinite(size(pivot));
  }
  static bool serves(const Pair& pivot, const Pair& other) {
    return serves(pivot.lane(0), other.lane(0)) && serves(pivot.lane(1), other.lane(1));
  }
  std::size_t at(std::size_t row, std::size_t column) const {
    return row * band + width + column - row;
  }
  bool factorise_middle() {
    for (std::size_t k = 0; k < size_; ++k) {
      for (std::size_t i = k; i < size_; ++i)
        if (!serves(middle_[k][k], middle_[i][k])) return false;
      for (std::size_t i = k + 1; i < size_; ++i) {
        middle_[i][k] /= middle_[k][k];
        for (std::size_t j = k + 1; j < size_; ++j) middle_[i][j] -= middle_[i][k] * middle_[k][j];
      }
    }
    return true;
  }
  void solve_middle(std::array<Scalar, most>& x) const {
    for (std::size_t k = 0; k < size_; ++k)
      for (std::size_t j = 0; j < k; ++j) x[k] -= middle_[k][j] * x[j];
    for (std::size_t k = size_; k-- > 0;) {
      for (std::size_t j = k + 1; j < size_; ++j) x[k] -= middle_[k][j] * x[j];
      x[k] /= middle_[k][k];
    }
  }

  std::size_t n_, chain_, size_;  ///< unknowns, those of a chain, those of the middle
  std::vector<Pair> rows_;        ///< of the chains, with those of the middle that they reach
  std::array<std::array<Scalar, most>, most> middle_{};
  std::vector<Pair> x_;
};

}  // namespace odeum::linear
