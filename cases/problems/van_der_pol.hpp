// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, for odeint's rosenbrock4.
#include <cstddef>

namespace odeum::cases {

/// x'' = (mu (1 - x^2) x' - x) / eps, as a first-order system: an electric circuit, not mechanics.
struct VanDerPol {
  static constexpr std::size_t dimension = 2;
  double mu = 1, eps = 1;

  template <class R>
  void rhs(R, const R* y, R* f) const {
    f[0] = y[1];
    f[1] = (mu * (1 - y[0] * y[0]) * y[1] - y[0]) / eps;
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = 0;
    j[1] = 1;
    j[2] = (-2 * mu * y[0] * y[1] - 1) / eps;
    j[3] = mu * (1 - y[0] * y[0]) / eps;
  }
};

}  // namespace odeum::cases
