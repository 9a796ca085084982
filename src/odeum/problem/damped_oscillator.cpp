// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/problem/damped_oscillator.hpp"

#include <cmath>

namespace odeum {
namespace {

/// a b - c d with the rounding of both products recovered (Kahan's algorithm).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double rounding = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + rounding;
}

}  // namespace

// With beta = d/2m, omega^2 = k/m and s^2 = beta^2 - omega^2:
//   y = e^{-beta t} (y0 C + (v0 + beta y0) S),   y' = e^{-beta t} (v0 C - (beta v0 + omega^2 y0) S)
// where C = cosh(s t), S = sinh(s t)/s, both smooth in s^2 through zero (there C = 1, S = t) and
// cos, sin of the modulus below it.
void damped_oscillator_solution(double m, double d, double k, double y0, double v0, double t,
                                double* state) {
  const double beta = d / (2 * m);
  const double omega_squared = k / m;
  const double s_squared = difference_of_products(d, d, 4 * m, k) / (4 * m * m);
  double c = 0, s_over = 0;  // e^{-beta t} C and e^{-beta t} S
  if (s_squared > 0) {
    const double s = std::sqrt(s_squared);
    const double slow = omega_squared / (beta + s);  // the root nearer zero, without beta - s
    const double decay = std::exp(-slow * t);
    c = decay * (1 + std::exp(-2 * s * t)) / 2;
    s_over = decay * -std::expm1(-2 * s * t) / (2 * s);
  } else {
    const double w = std::sqrt(-s_squared);
    const double decay = std::exp(-beta * t);
    c = decay * std::cos(w * t);
    s_over = decay * (w > 0 ? std::sin(w * t) / w : t);
  }
  state[0] = y0 * c + (v0 + beta * y0) * s_over;
  state[1] = v0 * c - (beta * v0 + omega_squared * y0) * s_over;
}

}  // namespace odeum
