// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/kernel/stage_transform.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "odeum/linear/dense_lu.hpp"
#include "odeum/linear/eigenvalues.hpp"

namespace odeum {
namespace {

using Real = long double;
using LongComplex = std::complex<Real>;
template <class Scalar>
using Matrix = std::vector<std::vector<Scalar>>;  // by rows

template <class Scalar>
linear::Lu<Scalar> factors(const Matrix<Scalar>& matrix) {
  linear::Lu<Scalar> lu(matrix.size());
  Scalar* entry = lu.data();
  for (const auto& row : matrix)
    for (const Scalar& x : row) *entry++ = x;
  if (!lu.factorise()) throw std::logic_error("a matrix of a Runge-Kutta method is singular");
  return lu;
}

template <class Scalar>
std::vector<Scalar> solve(const Matrix<Scalar>& matrix, std::vector<Scalar> x) {
  factors(matrix).solve(x.data());
  return x;
}

template <class Scalar>
Matrix<Scalar> transposed(const Matrix<Scalar>& matrix) {
  Matrix<Scalar> result(matrix.size(), std::vector<Scalar>(matrix.size()));
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j) result[j][i] = matrix[i][j];
  return result;
}

template <class Scalar>
Matrix<Scalar> inverse(const Matrix<Scalar>& matrix) {
  const std::size_t s = matrix.size();
  linear::Lu<Scalar> lu = factors(matrix);
  Matrix<Scalar> columns(s, std::vector<Scalar>(s));
  for (std::size_t j = 0; j < s; ++j) {
    columns[j][j] = 1;
    lu.solve(columns[j].data());
  }
  return transposed(columns);
}

/// The eigenvector of the eigenvalue near `mu` whose last entry is one, by inverse iteration: an
/// eigenvalue correct to 1e-15 gains as many digits in each of the three iterations.
std::vector<LongComplex> eigenvector(const Matrix<Real>& matrix, LongComplex mu) {
  const std::size_t s = matrix.size();
  Matrix<LongComplex> shifted(s, std::vector<LongComplex>(s));
  for (std::size_t i = 0; i < s; ++i)
    for (std::size_t j = 0; j < s; ++j)
      shifted[i][j] = matrix[i][j] - (i == j ? mu : LongComplex());
  linear::Lu<LongComplex> lu = factors(shifted);
  std::vector<LongComplex> x(s, 1);
  for (int iteration = 0; iteration < 3; ++iteration) {
    lu.solve(x.data());
    const LongComplex last = x.back();
    for (LongComplex& entry : x) entry /= last;
  }
  return x;
}

std::vector<double> as_doubles(const std::vector<Real>& x) { return {x.begin(), x.end()}; }

/// e^T = (b_hat - b)^T A^-1, where sum_i b_hat_i c_i^(k-1) = 1/k - (gamma0 for k = 1), k = 1..S.
std::vector<Real> error_weights(const Matrix<Real>& a, const std::vector<Real>& b, Real gamma0) {
  const std::size_t s = a.size();
  Matrix<Real> vandermonde(s, std::vector<Real>(s, 1));
  std::vector<Real> right(s);
  for (std::size_t k = 0; k < s; ++k) {
    for (std::size_t i = 0; k > 0 && i < s; ++i) {
      Real c = 0;
      for (const Real entry : a[i]) c += entry;
      vandermonde[k][i] = vandermonde[k - 1][i] * c;
    }
    right[k] = 1 / static_cast<Real>(k + 1) - (k == 0 ? gamma0 : 0);
  }
  std::vector<Real> difference = solve(vandermonde, right);
  for (std::size_t i = 0; i < s; ++i) difference[i] -= b[i];
  return solve(transposed(a), difference);
}

}  // namespace

StageTransform make_stage_transform(const std::vector<double>& a, const std::vector<double>& b) {
  const std::size_t s = b.size();
  const std::vector<Real> row(b.begin(), b.end());
  Matrix<Real> matrix(s);
  for (std::size_t i = 0; i < s; ++i) matrix[i].assign(&a[i * s], &a[i * s] + s);
  const Matrix<Real> inverted = inverse(matrix);
  std::vector<double> rounded;
  for (const auto& entries : inverted)
    rounded.insert(rounded.end(), entries.begin(), entries.end());
  // One of each pair of conjugates; the real one first.
  std::vector<std::complex<double>> near = eigenvalues(rounded, s);
  std::erase_if(near, [](const auto& mu) { return mu.imag() < 0; });
  std::sort(near.begin(), near.end(),
            [](const auto& x, const auto& y) { return x.imag() < y.imag(); });

  Matrix<LongComplex> columns;  // of T: those of `near`, then their conjugates
  for (const auto& mu : near) columns.push_back(eigenvector(inverted, LongComplex(mu)));
  for (std::size_t k = 0; columns.size() < s; ++k)
    if (near[k].imag() > 0) {
      columns.push_back(columns[k]);
      for (LongComplex& entry : columns.back()) entry = std::conj(entry);
    }
  const Matrix<LongComplex> ti = inverse(transposed(columns));

  StageTransform transform;
  transform.weights = as_doubles(solve(transposed(matrix), row));
  for (std::size_t k = 0; k < near.size(); ++k) {
    LongComplex mu = 0;  // the last row of A^-1 x = mu x, where x ends in one
    for (std::size_t j = 0; j < s; ++j) mu += inverted[s - 1][j] * columns[k][j];
    if (k == 0 && s % 2 == 1)
      transform.estimate = as_doubles(error_weights(matrix, row, 1 / mu.real()));
    transform.inverse_mu.emplace_back(Real(1) / mu);
    auto& column = transform.t.emplace_back();
    auto& inverse_row = transform.ti.emplace_back();
    for (std::size_t i = 0; i < s; ++i) {
      column.emplace_back(columns[k][i] * Real(near[k].imag() == 0 ? 1 : 2));
      inverse_row.emplace_back(ti[k][i]);
    }
  }
  return transform;
}

}  // namespace odeum
