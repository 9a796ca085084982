// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/problem/concepts.hpp"

namespace odeum::cases {

/// Mass, damping, stiffness and the position of the equilibrium. Where all but the damping are 1
/// and 0 the compiler is told so, for the timed runs.
struct OscillatorNumbers {
  double m = 1, d = 0, k = 5, rest = 0;
};
struct UnitNumbers {
  static constexpr double m = 1, k = 1, rest = 0;
  double d = 0;
};

/// m y'' + d y' + k (y - rest) = 0. The undamped type has no damping term, so that methods for
/// separable systems fit it.
template <bool Damped, class Numbers>
struct Oscillator : Numbers {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = Damped;
  using Numbers::m, Numbers::d, Numbers::k, Numbers::rest;

  template <class R>
  void acceleration(R, const R* q, const R* v, R* a) const {
    a[0] = -k / m * (q[0] - rest);
    if constexpr (Damped) a[0] -= d / m * v[0];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double, const double*, double* j) const {
    j[0] = 0;
    j[1] = 1;
    j[2] = -k / m;
    j[3] = -d / m;
  }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
  double energy(const double* y) const {
    return (k * (y[0] - rest) * (y[0] - rest) + m * y[1] * y[1]) / 2;
  }
};

}  // namespace odeum::cases
