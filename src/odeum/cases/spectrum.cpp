// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/linear/dense_limit.hpp"
#include "odeum/linear/eigenvalues.hpp"

namespace odeum::cases {
namespace {

using Vector = std::vector<double>;

/// A state of a case.
struct Moment {
  double t;
  Vector y;
};

double norm(const Vector& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

/// J v, by a central difference along v, which is of length 1, where the case offers no product.
Vector product(const Case& c, const Moment& at, const Vector& v) {
  const OdeView& view = c.problem.view;
  if (view.jacobian_times) {
    Vector found(v.size());
    view.jacobian_times(view.problem, at.t, at.y.data(), v.data(), found.data());
    return found;
  }
  // As in DifferenceIncrements, the state's size is the unit.
  const double size = norm(at.y);
  const double h = std::cbrt(std::numeric_limits<double>::epsilon()) * (size > 0 ? size : 1);
  Vector above(at.y), below(at.y), up(v.size()), down(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) above[i] += h * v[i], below[i] -= h * v[i];
  view.rhs(view.problem, at.t, above.data(), up.data());
  view.rhs(view.problem, at.t, below.data(), down.data());
  for (std::size_t i = 0; i < v.size(); ++i) up[i] = (up[i] - down[i]) / (2 * h);
  return up;
}

Vector dense_jacobian(const Case& c, const Moment& at) {
  const std::size_t n = c.y0.size();
  Vector matrix(n * n);
  if (const OdeView& view = c.problem.view; view.jacobian) {
    view.jacobian(view.problem, at.t, at.y.data(), matrix.data());
    return matrix;
  }
  for (std::size_t j = 0; j < n; ++j) {
    Vector unit(n);
    unit[j] = 1;
    const Vector column = product(c, at, unit);
    for (std::size_t i = 0; i < n; ++i) matrix[i * n + j] = column[i];
  }
  return matrix;
}

/// The matrix of Arnoldi's method after `most` products, whose eigenvalues approach the outermost
/// of the Jacobian; `size` is its dimension.
Vector arnoldi(const Case& c, const Moment& at, std::size_t most, std::size_t& size) {
  std::vector<Vector> basis(1, Vector(c.y0.size()));
  // A start with a part along every eigenvector: pseudo-random, the same in every run.
  std::uint32_t state = 1;
  for (double& x : basis[0]) {
    state = state * 1664525U + 1013904223U;
    x = state / 4294967296.0 - 0.5;
  }
  const double length = norm(basis[0]);
  for (double& x : basis[0]) x /= length;
  Vector h(most * most);
  for (size = 1;; ++size) {
    Vector w = product(c, at, basis.back());
    // Twice, since one orthogonalisation leaves rounding.
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t i = 0; i < size; ++i) {
        double dot = 0;
        for (std::size_t k = 0; k < w.size(); ++k) dot += w[k] * basis[i][k];
        for (std::size_t k = 0; k < w.size(); ++k) w[k] -= dot * basis[i][k];
        h[i * most + size - 1] += dot;
      }
    const double rest = norm(w);
    if (size == most || !(rest > 1e-9 * length)) break;
    h[size * most + size - 1] = rest;
    for (double& x : w) x /= rest;
    basis.push_back(std::move(w));
  }
  Vector part(size * size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) part[i * size + j] = h[i * most + j];
  return part;
}

using Eigenvalues = std::vector<std::complex<double>>;

/// Keeps the eigenvalues of Arnoldi's matrix that its leading part shares to a hundredth, and the
/// largest; the others have not converged.
Eigenvalues settled(const Vector& matrix, std::size_t size) {
  const std::size_t part = size * 3 / 4;
  Vector leading(part * part);
  for (std::size_t i = 0; i < part; ++i)
    for (std::size_t j = 0; j < part; ++j) leading[i * part + j] = matrix[i * size + j];
  const Eigenvalues before = eigenvalues(leading, part), now = eigenvalues(matrix, size);
  double size_of_largest = 0;
  for (const auto& z : now) size_of_largest = std::max(size_of_largest, std::abs(z));
  Eigenvalues found;
  for (const auto& z : now)
    if (std::abs(z) == size_of_largest || std::ranges::any_of(before, [&](const auto& other) {
          return std::abs(other - z) <= 0.01 * std::abs(z);
        }))
      found.push_back(z);
  return found;
}

/// The eigenvalues in the upper half plane; empty where the Jacobian is not finite.
Eigenvalues eigenvalues_at(const Case& c, const Moment& at) {
  constexpr std::size_t products = 96;
  std::size_t n = c.y0.size();
  const bool dense = n <= dense_dimension_limit;
  const Vector matrix = dense ? dense_jacobian(c, at) : arnoldi(c, at, products, n);
  if (std::ranges::any_of(matrix, [](double x) { return !std::isfinite(x); })) return {};
  // Where the iteration ended before, its matrix has all that the start has a part along.
  const bool whole = dense || n < products;
  Eigenvalues upper;
  for (const std::complex<double>& z : whole ? eigenvalues(matrix, n) : settled(matrix, n))
    if (z.imag() >= 0) upper.push_back(z);
  return upper;
}

double largest(const std::vector<std::complex<double>>& values) {
  double size = 0;
  for (const auto& z : values) size = std::max(size, std::abs(z));
  return size;
}

}  // namespace

std::vector<std::complex<double>> outermost_eigenvalues(const Case& c, double t,
                                                        const std::vector<double>& y) {
  return eigenvalues_at(c, {t, y});
}

Spectrum spectrum_of(const Case& c) {
  if (!c.problem.view.rhs || c.y0.empty()) return {};
  Spectrum start{eigenvalues_at(c, {c.t0, c.y0}), c.t0};
  if (c.stops.empty() || !c.truth.at) return start;
  Moment last{c.stops.back(), Vector(c.y0.size())};
  if (!c.truth.at(last.t, last.y.data())) return start;
  Spectrum end{eigenvalues_at(c, last), last.t};
  // The start stands for both where they agree to rounding.
  return largest(end.eigenvalues) > 1.001 * largest(start.eigenvalues) ? end : start;
}

}  // namespace odeum::cases
