// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/growth.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "odeum/core/numbers.hpp"

namespace odeum::judge {
namespace {

using Complex = std::complex<double>;

/// log of the larger root of r^2 = a r + b, in modulus.
double log_larger_root(Complex a, Complex b) {
  const Complex root = std::sqrt(a * a / 4.0 + b);
  return std::log(std::max(std::abs(a / 2.0 + root), std::abs(a / 2.0 - root)));
}

/// <x, y>, conjugate in x.
Complex dot(const std::vector<Complex>& x, const std::vector<Complex>& y) {
  Complex sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += std::conj(x[i]) * y[i];
  return sum;
}

double norm(const std::vector<Complex>& x) { return std::sqrt(dot(x, x).real()); }

void subtract(std::vector<Complex>& x, Complex factor, const std::vector<Complex>& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= factor * y[i];
}

/// The growth from the lengths of the states: their logarithm rises by the same amount each step
/// where one root of the iteration dominates. Noise: how much the amount varies.
Growth growth_by_norms(std::span<const PlaneState> states) {
  double low = infinity, high = -infinity;
  const double first = std::log(length(states.front()));
  double last = first;
  for (std::size_t k = 1; k < states.size(); ++k) {
    const double next = std::log(length(states[k]));
    low = std::min(low, next - last);
    high = std::max(high, next - last);
    last = next;
  }
  // A slowly decaying variation continues beyond the window, hence the factor of 4.
  return {(last - first) / static_cast<double>(states.size() - 1),
          4 * (high - low) + growth_rounding};
}

/// The growth from the recurrence s_{k+2} = a s_{k+1} + b s_k of the states as complex numbers,
/// which every linear one-step map of a plane obeys (a its trace, -b its determinant, both real)
/// and every iteration that two roots dominate: the larger root of r^2 = a r + b. Sees that a
/// symplectic map is bounded although its states change in length. Noise: the effect of the scatter
/// of a least-squares fit; infinite where the states do not determine the recurrence.
Growth growth_by_recurrence(std::span<const PlaneState> states, Coefficients coefficients) {
  const auto restricted = [coefficients](Complex c) {
    return coefficients == Coefficients::real ? c.real() : c;
  };
  // Each equation is divided by its own size, so that growth gives none of them more weight.
  std::vector<Complex> u, v, w;  // s_{k+1}, s_k, s_{k+2}
  for (std::size_t k = 0; k + 2 < states.size(); ++k) {
    const double scale = 1 / std::max(length(states[k]), length(states[k + 1]));
    const auto scaled = [&](const PlaneState& s) { return Complex(s[0] * scale, s[1] * scale); };
    u.push_back(scaled(states[k + 1]));
    v.push_back(scaled(states[k]));
    w.push_back(scaled(states[k + 2]));
  }
  const auto equations = static_cast<double>(u.size());
  // Least squares of w = a u + b v by orthogonalisation: v = uv u + v', w = alpha u + b v' + rest.
  const double u_norm = norm(u);
  const Complex uv = restricted(dot(u, v)) / (u_norm * u_norm);
  subtract(v, uv, u);
  const double v_norm = norm(v);
  constexpr double parallel = 1e-8;  // a geometric sequence: the recurrence is not determined
  if (!(v_norm > parallel * std::sqrt(equations))) return {0, infinity};
  const Complex alpha = restricted(dot(u, w)) / (u_norm * u_norm);
  subtract(w, alpha, u);
  const Complex b = restricted(dot(v, w)) / (v_norm * v_norm);
  subtract(w, b, v);
  const double scatter =
      4 * std::max(norm(w) / std::sqrt(equations - 2), std::numeric_limits<double>::epsilon());
  // alpha and b are independent, a = alpha - uv b is tied to b: near a double root separate errors
  // of a and b would overestimate the scatter.
  const double value = log_larger_root(alpha - uv * b, b);
  constexpr std::array<Complex, 4> all_directions{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const std::span directions(all_directions.data(), coefficients == Coefficients::real ? 2 : 4);
  double noise = 0;
  for (const Complex direction_alpha : directions)
    for (const Complex direction_b : directions) {
      const Complex moved_alpha = alpha + direction_alpha * scatter / u_norm;
      const Complex moved_b = b + direction_b * scatter / v_norm;
      noise =
          std::max(noise, std::abs(log_larger_root(moved_alpha - uv * moved_b, moved_b) - value));
    }
  return {value, noise + growth_rounding};
}

}  // namespace

double length(const PlaneState& state) { return std::hypot(state[0], state[1]); }

Growth dominant_growth(std::span<const PlaneState> states, Coefficients coefficients) {
  const Growth by_recurrence = growth_by_recurrence(states, coefficients);
  if (coefficients == Coefficients::real && std::isfinite(by_recurrence.noise))
    return by_recurrence;
  const Growth by_norms = growth_by_norms(states);
  return by_recurrence.noise < by_norms.noise ? by_recurrence : by_norms;
}

}  // namespace odeum::judge
