// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "odeum/linear/dense_lu.hpp"

/// Stability polynomials R(z) = w(x) P_n(x) of order 2 N, x = start + z / scale: w is positive with
/// N pairs of complex zeros, the P_n are orthogonal on [-1, 1] with the weight w(x)^2 / sqrt(1 -
/// x^2). w P_n then oscillates between bounds that are nearly equal, as T_n does (Bernstein), so
/// that |R| <= 1 on nearly the longest interval that its order allows, and the P_n have a
/// recurrence of three terms (Abdulle, Medovikov, Numer. Math. 90 (2001) 1-18).
namespace odeum {

/// P_0 = 1, P_{j+1}(x) = (x - a_j) P_j(x) - b_j P_{j-1}(x).
struct OrthogonalRecurrence {
  std::vector<double> a, b;
};

/// f(x), f'(x), f''(x) / 2, ...
using Jet = std::array<double, 5>;
inline Jet product(const Jet& f, const Jet& g) {
  Jet h{};
  for (std::size_t i = 0; i < h.size(); ++i)
    for (std::size_t j = 0; i + j < h.size(); ++j) h[i + j] += f[i] * g[j];
  return h;
}

/// w(x) = prod |x - zero|^2 over complex zeros, of which one of each pair is given.
template <class Zeros>
Jet value_of_pairs(const Zeros& zeros, double x) {
  Jet w{1};
  for (const std::complex<double>& zero : zeros)
    w = product(w, {std::norm(x - zero), 2 * (x - zero.real()), 1});
  return w;
}

/// The first `degree` coefficients, by Stieltjes' procedure: a_j = <x P_j, P_j> / <P_j, P_j> and
/// b_j = <P_j, P_j> / <P_{j-1}, P_{j-1}>. The quadrature of Gauss and Chebyshev is exact for them.
template <class Zeros>
OrthogonalRecurrence weighted_chebyshev(const Zeros& zeros, int degree) {
  const std::size_t nodes = static_cast<std::size_t>(degree) + 2 * zeros.size() + 1;
  std::vector<double> x(nodes), weight(nodes), before(nodes, 0.0), now(nodes, 1.0);
  for (std::size_t i = 0; i < nodes; ++i) {
    x[i] = std::cos((static_cast<double>(i) + 0.5) * std::numbers::pi / static_cast<double>(nodes));
    const double w = value_of_pairs(zeros, x[i])[0];
    weight[i] = w * w;
  }
  OrthogonalRecurrence found;
  double square_before = 1;
  for (int j = 0; j < degree; ++j) {
    double square = 0, moment = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
      const double part = weight[i] * now[i] * now[i];
      square += part;
      moment += x[i] * part;
    }
    found.a.push_back(moment / square);
    found.b.push_back(j > 0 ? square / square_before : 0);
    for (std::size_t i = 0; i < nodes; ++i) {
      const double next = (x[i] - found.a.back()) * now[i] - found.b.back() * before[i];
      before[i] = now[i];
      now[i] = next;
    }
    square_before = square;
  }
  return found;
}

/// 2^n P_n at x, whose size is moderate.
inline Jet value_of(const OrthogonalRecurrence& p, double x) {
  Jet before{}, now{1};
  for (std::size_t j = 0; j < p.a.size(); ++j) {
    Jet next = product({2 * (x - p.a[j]), 2}, now);
    for (std::size_t k = 0; k < next.size(); ++k) next[k] -= 4 * p.b[j] * before[k];
    before = now;
    now = next;
  }
  return now;
}

/// A polynomial of degree s = n + 2 N.
template <std::size_t N>
struct WeightedPolynomial {
  std::array<std::complex<double>, N> zeros;  ///< of w
  OrthogonalRecurrence recurrence;            ///< of P_n
  double start = 0, scale = 0;
  bool found = false;

  Jet at(double x) const { return product(value_of_pairs(zeros, x), value_of(recurrence, x)); }
};

/// What is given: the start 1 + `beyond` / s^2, the damping |R(-1)|, and a guess of the zeros 1 +
/// (u + i v) / s^2, of which u and v hardly depend on s.
template <std::size_t N>
struct WeightedFamily {
  double beyond, damping;
  std::array<std::complex<double>, N> zeros;
};

/// Newton's method with a matrix of quotients of differences; whether it converged.
template <std::size_t n, class Defects>
bool solve_by_newton(std::array<double, n>& x, const Defects& defects) {
  constexpr double distance = 1e-7;
  linear::DenseLu lu(n);
  for (int iteration = 0; iteration < 30; ++iteration) {
    std::array<double, n> change = defects(x);
    for (std::size_t j = 0; j < n; ++j) {
      std::array<double, n> moved = x;
      moved[j] += distance;
      const std::array<double, n> other = defects(moved);
      for (std::size_t i = 0; i < n; ++i) lu.data()[i * n + j] = (other[i] - change[i]) / distance;
    }
    if (!lu.factorise()) return false;
    lu.solve(change.data());
    double length = 0;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] -= change[i];
      length += std::abs(change[i]);
    }
    // The next change would be smaller by the accuracy of the quotients, 1e-7.
    if (length < 1e-7) return true;
  }
  return false;
}

/// The zeros follow from R^(k)(start) R(start)^(k-1) = R'(start)^k, k = 2, ..., 2 N, which is order
/// 2 N, and the damping, by Newton's method.
template <std::size_t N>
WeightedPolynomial<N> weighted_polynomial(const WeightedFamily<N>& family, int s) {
  constexpr std::size_t unknowns = 2 * N;
  using Vector = std::array<double, unknowns>;
  const double square = static_cast<double>(s) * s;
  WeightedPolynomial<N> p;
  p.start = 1 + family.beyond / square;
  const auto defects = [&](const Vector& x) {
    for (std::size_t k = 0; k < N; ++k) p.zeros[k] = {1 + x[2 * k] / square, x[2 * k + 1] / square};
    p.recurrence = weighted_chebyshev(p.zeros, s - static_cast<int>(unknowns));
    const Jet r = p.at(p.start);
    p.scale = r[1] / r[0];
    Vector defect;
    double power = p.scale, factorial = 1;
    for (std::size_t k = 2; k <= unknowns; ++k) {
      power *= p.scale;
      factorial *= static_cast<double>(k);
      defect[k - 2] = factorial * r[k] / (r[0] * power) - 1;
    }
    defect[unknowns - 1] = std::abs(p.at(-1)[0] / r[0]) - family.damping;
    return defect;
  };
  Vector x;
  for (std::size_t k = 0; k < N; ++k) {
    x[2 * k] = family.zeros[k].real();
    x[2 * k + 1] = family.zeros[k].imag();
  }
  p.found = solve_by_newton(x, defects);
  defects(x);
  return p;
}

}  // namespace odeum
