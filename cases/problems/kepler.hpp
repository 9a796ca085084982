// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>

#include "odeum/problem/concepts.hpp"

namespace odeum::cases {

/// q'' = -q / |q|^3 in a plane.
struct Kepler {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = false;

  template <class R>
  void acceleration(R, const R* q, const R*, R* a) const {
    const R r2 = q[0] * q[0] + q[1] * q[1];
    const R pull = -1 / (r2 * std::sqrt(r2));
    a[0] = pull * q[0];
    a[1] = pull * q[1];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  void jacobian(double, const double* q, double* j) const {
    const double r2 = q[0] * q[0] + q[1] * q[1];
    const double pull = 1 / (r2 * std::sqrt(r2));
    for (int i = 0; i < 16; ++i) j[i] = 0;
    j[2] = j[7] = 1;
    j[8] = pull * (3 * q[0] * q[0] / r2 - 1);
    j[9] = j[12] = pull * 3 * q[0] * q[1] / r2;
    j[13] = pull * (3 * q[1] * q[1] / r2 - 1);
  }
  /// With s = |q|^2 and p = s^(-3/2), products are convolutions of series and 2 s p' = -3 p s'.
  void taylor(double, const double* y, int order, double* c) const {
    std::array<double, highest_taylor_order + 1> s{}, p{};
    const auto n = static_cast<std::size_t>(order);
    for (std::size_t i = 0; i < 4; ++i) c[i] = y[i];
    for (std::size_t k = 0; k < n; ++k) {
      const double* const q = c;  // q[4 j] and q[4 j + 1] are the coefficients of number j
      for (std::size_t j = 0; j <= k; ++j)
        s[k] += q[4 * j] * q[4 * (k - j)] + q[4 * j + 1] * q[4 * (k - j) + 1];
      if (k == 0) {
        p[0] = 1 / (s[0] * std::sqrt(s[0]));
      } else {
        for (std::size_t j = 0; j < k; ++j)
          p[k] -= (1.5 * static_cast<double>(k - j) + static_cast<double>(j)) * p[j] * s[k - j];
        p[k] /= static_cast<double>(k) * s[0];
      }
      double ax = 0, ay = 0;
      for (std::size_t j = 0; j <= k; ++j) {
        ax -= q[4 * j] * p[k - j];
        ay -= q[4 * j + 1] * p[k - j];
      }
      double* const next = c + 4 * (k + 1);
      const double scale = 1 / static_cast<double>(k + 1);
      next[0] = scale * c[4 * k + 2];
      next[1] = scale * c[4 * k + 3];
      next[2] = scale * ax;
      next[3] = scale * ay;
    }
  }
  double energy(const double* y) const {
    return (y[2] * y[2] + y[3] * y[3]) / 2 - 1 / std::hypot(y[0], y[1]);
  }
};

}  // namespace odeum::cases
