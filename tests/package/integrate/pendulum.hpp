// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

/// q'' = -sin q from q = 1 at rest. Its period is 4 K(sin(1/2)), 6.6996..., and its energy
/// v^2/2 - cos q is constant.
struct Pendulum {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[1];
    dydt[1] = -std::sin(y[0]);
  }
  static double energy(const std::array<double, 2>& y) { return y[1] * y[1] / 2 - std::cos(y[0]); }
  /// Four times the complete elliptic integral of the first kind, modulus sin(1/2), by the
  /// arithmetic-geometric mean.
  static double period() {
    double a = 1, b = std::cos(0.5);
    for (int i = 0; i < 6; ++i) {
      const double mean = (a + b) / 2;
      b = std::sqrt(a * b);
      a = mean;
    }
    return 2 * std::acos(-1.0) / a;
  }
};
