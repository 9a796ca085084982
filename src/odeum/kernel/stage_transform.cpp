// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/kernel/stage_transform.hpp"

#include <algorithm>
#include <cmath>

namespace odeum {
namespace {

using Real = long double;
using Wide = std::complex<Real>;
using Matrix = std::vector<std::vector<Wide>>;

Matrix identity(std::size_t s) {
  Matrix m(s, std::vector<Wide>(s));
  for (std::size_t i = 0; i < s; ++i) m[i][i] = 1;
  return m;
}

/// X of M X = R, by Gaussian elimination with partial pivoting.
Matrix solve(Matrix m, Matrix r) {
  const std::size_t s = m.size();
  for (std::size_t k = 0; k < s; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < s; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    std::swap(m[k], m[pivot]);
    std::swap(r[k], r[pivot]);
    for (std::size_t i = 0; i < s; ++i) {
      if (i == k) continue;
      const Wide factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < s; ++j) m[i][j] -= factor * m[k][j];
      for (std::size_t j = 0; j < r[i].size(); ++j) r[i][j] -= factor * r[k][j];
    }
  }
  for (std::size_t i = 0; i < s; ++i)
    for (Wide& entry : r[i]) entry /= m[i][i];
  return r;
}

/// The characteristic polynomial, lowest coefficient first, the highest one: Faddeev, Le Verrier.
std::vector<Wide> characteristic_polynomial(const Matrix& m) {
  const std::size_t s = m.size();
  std::vector<Wide> p(s + 1);
  p[s] = 1;
  Matrix b = identity(s);
  for (std::size_t k = 1; k <= s; ++k) {
    Matrix mb(s, std::vector<Wide>(s));
    Wide trace = 0;
    for (std::size_t i = 0; i < s; ++i) {
      for (std::size_t j = 0; j < s; ++j)
        for (std::size_t l = 0; l < s; ++l) mb[i][j] += m[i][l] * b[l][j];
      trace += mb[i][i];
    }
    p[s - k] = -trace / static_cast<Real>(k);
    b = mb;
    for (std::size_t i = 0; i < s; ++i) b[i][i] += p[s - k];
  }
  return p;
}

/// All roots at once (Weierstrass, Durand, Kerner); they must be simple.
std::vector<Wide> roots(const std::vector<Wide>& p) {
  const std::size_t s = p.size() - 1;
  std::vector<Wide> x(s);
  for (std::size_t k = 0; k < s; ++k) x[k] = Real(4) * std::pow(Wide(0.4L, 0.9L), Real(k));
  for (int sweep = 0; sweep < 500; ++sweep)
    for (std::size_t k = 0; k < s; ++k) {
      Wide value = 0, product = 1;
      for (std::size_t i = s + 1; i-- > 0;) value = value * x[k] + p[i];
      for (std::size_t j = 0; j < s; ++j)
        if (j != k) product *= x[k] - x[j];
      x[k] -= value / product;
    }
  return x;
}

/// e^T = (b_hat - b)^T A^-1, where sum_i b_hat_i c_i^(k-1) = 1/k - (gamma0 for k = 1), k = 1..S.
std::vector<double> error_weights(const Matrix& a, const std::vector<double>& b, Real gamma0) {
  const std::size_t s = a.size();
  Matrix vandermonde = identity(s), right(s, std::vector<Wide>(1)), transposed = identity(s);
  for (std::size_t i = 0; i < s; ++i) {
    Wide c = 0, power = 1;
    for (const Wide& entry : a[i]) c += entry;
    for (std::size_t k = 0; k < s; ++k, power *= c) vandermonde[k][i] = power;
    right[i][0] = 1 / static_cast<Real>(i + 1) - (i == 0 ? gamma0 : 0);
    for (std::size_t j = 0; j < s; ++j) transposed[i][j] = a[j][i];
  }
  Matrix difference = solve(vandermonde, right);
  for (std::size_t i = 0; i < s; ++i) difference[i][0] -= b[i];
  const Matrix weights = solve(transposed, difference);
  std::vector<double> e;
  for (const auto& row : weights) e.push_back(static_cast<double>(row[0].real()));
  return e;
}

}  // namespace

StageTransform make_stage_transform(const std::vector<double>& a, const std::vector<double>& b) {
  const std::size_t s = b.size();
  Matrix matrix = identity(s);
  for (std::size_t i = 0; i < s; ++i)
    for (std::size_t j = 0; j < s; ++j) matrix[i][j] = a[i * s + j];
  const Matrix inverse = solve(matrix, identity(s));
  std::vector<Wide> mu = roots(characteristic_polynomial(inverse));
  // Real first, then pair by pair.
  std::sort(mu.begin(), mu.end(),
            [](const Wide& x, const Wide& y) { return std::abs(x.imag()) < std::abs(y.imag()); });
  Matrix t = identity(s);
  for (std::size_t k = 0; k < s; ++k) {
    // Inverse iteration, a little off the eigenvalue so that the matrix is regular.
    Matrix shifted = inverse, v(s, std::vector<Wide>(1, 1));
    for (std::size_t i = 0; i < s; ++i) shifted[i][i] -= mu[k] * Wide(1 + 1e-10L);
    for (int iteration = 0; iteration < 4; ++iteration) {
      v = solve(shifted, v);
      const Wide last = v[s - 1][0];
      for (auto& entry : v) entry[0] /= last;
    }
    for (std::size_t i = 0; i < s; ++i) t[i][k] = v[i][0];
  }
  const Matrix ti = solve(t, identity(s));

  StageTransform transform;
  for (std::size_t k = 0; k < s; k += k == 0 && s % 2 == 1 ? 1 : 2) {
    const bool real = k == 0 && s % 2 == 1;
    transform.inverse_mu.emplace_back(real ? Wide(1 / mu[k].real()) : Wide(1) / mu[k]);
    auto& column = transform.t.emplace_back();
    auto& row = transform.ti.emplace_back();
    for (std::size_t i = 0; i < s; ++i) {
      column.emplace_back(t[i][k] * Real(real ? 1 : 2));
      row.emplace_back(ti[k][i]);
    }
  }
  if (s % 2 == 1) transform.estimate = error_weights(matrix, b, 1 / mu[0].real());
  return transform;
}

}  // namespace odeum
