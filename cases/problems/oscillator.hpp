// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/problem/concepts.hpp"

namespace odeum::cases {

/// x'' + c x' + x = 0. The undamped type has no damping term, so that it is separable.
template <bool Damped>
struct UnitOscillator {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = Damped;
  double c = 0;

  template <class R>
  void acceleration(R, const R* q, const R* v, R* a) const {
    a[0] = -q[0];
    if constexpr (Damped) a[0] -= c * v[0];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double, const double*, double* j) const {
    j[0] = 0;
    j[1] = 1;
    j[2] = -1;
    j[3] = -c;
  }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
  double energy(const double* y) const { return (y[0] * y[0] + y[1] * y[1]) / 2; }
};

}  // namespace odeum::cases
