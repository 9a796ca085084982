// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <complex>
#include <cstddef>
#include <utility>

/// Runge-Kutta coefficients as data. Everything that follows from A and b is derived: the nodes c
/// (row sums), explicit or not, first-same-as-last, the stability function.
namespace odeum {

/// Whether each row i of a square matrix is zero from entry i + `beyond` on.
constexpr bool zero_from(const auto& matrix, std::size_t beyond) {
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = i + beyond; j < matrix.size(); ++j)
      if (matrix[i][j] != 0) return false;
  return true;
}

/// A Runge-Kutta method of S stages, with an embedded row where `b_hat` is not all zero. Its
/// coefficients are in double, or to more digits for runs in extended precision.
template <std::size_t S, class Real = double>
struct Tableau {
  static constexpr std::size_t stages = S;
  std::array<std::array<Real, S>, S>
      a{};  ///< a[i][j]: weight of stage j in the argument of stage i
  std::array<Real, S> b{};
  int order = 0;
  std::array<Real, S> b_hat{};  ///< the embedded row, the one whose difference estimates the error
  int order_hat = 0;

  constexpr Real c(std::size_t i) const {
    Real sum = 0;
    for (std::size_t j = 0; j < S; ++j) sum += a[i][j];
    return sum;
  }
  constexpr bool embedded() const { return order_hat != 0; }
  /// b - b_hat, the weights of the error estimate.
  constexpr std::array<Real, S> difference() const {
    std::array<Real, S> weights = b;
    for (std::size_t i = 0; i < S; ++i) weights[i] -= b_hat[i];
    return weights;
  }
  constexpr bool is_explicit() const { return zero_from(a, 0); }
  /// Stages depend on earlier ones and themselves only.
  constexpr bool is_diagonally_implicit() const { return zero_from(a, 1); }
  /// First same as last: the argument of the last stage is the new state.
  constexpr bool first_same_as_last() const {
    if (a[0][0] != 0) return false;
    for (std::size_t j = 0; j < S; ++j)
      if (a[S - 1][j] != b[j]) return false;
    return is_explicit();
  }
  /// The same stages with another row of weights.
  constexpr Tableau with_row(const std::array<Real, S>& row, int row_order) const {
    Tableau t = *this;
    t.b = row;
    t.order = row_order;
    t.b_hat = {};
    t.order_hat = 0;
    return t;
  }
};

/// The same coefficients in double.
template <std::size_t S>
constexpr Tableau<S> rounded(const Tableau<S, long double>& digits) {
  Tableau<S> t;
  for (std::size_t i = 0; i < S; ++i) {
    for (std::size_t j = 0; j < S; ++j) t.a[i][j] = static_cast<double>(digits.a[i][j]);
    t.b[i] = static_cast<double>(digits.b[i]);
    t.b_hat[i] = static_cast<double>(digits.b_hat[i]);
  }
  t.order = digits.order;
  t.order_hat = digits.order_hat;
  return t;
}

/// The pivots of Gaussian elimination with partial pivoting; their product is the determinant.
template <class Complex, std::size_t S>
std::array<Complex, S> pivots_of(std::array<std::array<Complex, S>, S> m) {
  std::array<Complex, S> pivots{};
  for (std::size_t k = 0; k < S; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < S; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    std::swap(m[k], m[pivot]);
    pivots[k] = pivot == k ? m[k][k] : -m[k][k];
    if (m[k][k] == Complex(0)) continue;
    for (std::size_t i = k + 1; i < S; ++i) {
      const Complex factor = m[i][k] / m[k][k];
      if (factor == Complex(0)) continue;
      for (std::size_t j = k; j < S; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return pivots;
}

/// R(z) = det(I - z A + z 1 b^T) / det(I - z A), which unlike 1 + z b^T (I - z A)^{-1} 1 loses no
/// digits where z is large (Hairer, Wanner, Solving ODEs II, (IV.3.3)).
template <std::size_t S>
std::complex<double> stability_function(const Tableau<S>& tableau, std::complex<double> z) {
  using Complex = std::complex<double>;
  std::array<std::array<Complex, S>, S> below{}, above{};
  for (std::size_t i = 0; i < S; ++i)
    for (std::size_t j = 0; j < S; ++j) {
      below[i][j] = (i == j ? 1.0 : 0.0) - z * tableau.a[i][j];
      above[i][j] = (i == j ? 1.0 : 0.0) - z * (tableau.a[i][j] - tableau.b[j]);
    }
  const auto numerator = pivots_of(above), denominator = pivots_of(below);
  Complex result = 1.0;
  for (std::size_t k = 0; k < S; ++k) result *= numerator[k] / denominator[k];
  return result;
}

}  // namespace odeum
