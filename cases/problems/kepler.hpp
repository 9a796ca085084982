// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "odeum/problem/concepts.hpp"

namespace odeum::cases {

/// q'' = -q / |q|^3 in a plane.
struct Kepler {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = false;

  void acceleration(double, const double* q, const double*, double* a) const {
    const double r2 = q[0] * q[0] + q[1] * q[1];
    const double pull = -1 / (r2 * std::sqrt(r2));
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
  double energy(const double* y) const {
    return (y[2] * y[2] + y[3] * y[3]) / 2 - 1 / std::hypot(y[0], y[1]);
  }
};

}  // namespace odeum::cases
