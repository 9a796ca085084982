// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, for odeint's rosenbrock4.
#include <cstddef>

namespace odeum::cases {

/// Three species; reaction rates that span nine decades.
struct Robertson {
  static constexpr std::size_t dimension = 3;
  double k1 = 0.04, k2 = 3e7, k3 = 1e4;

  template <class R>
  void rhs(R, const R* y, R* f) const {
    const R first = k1 * y[0], second = k2 * y[1] * y[1], third = k3 * y[1] * y[2];
    f[0] = -first + third;
    f[1] = first - third - second;
    f[2] = second;
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = -k1;
    j[1] = k3 * y[2];
    j[2] = k3 * y[1];
    j[3] = k1;
    j[4] = -k3 * y[2] - 2 * k2 * y[1];
    j[5] = -k3 * y[1];
    j[6] = 0;
    j[7] = 2 * k2 * y[1];
    j[8] = 0;
  }
};

}  // namespace odeum::cases
