// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Heun's method, the explicit trapezoidal rule: the mean of f at the start and at the Euler
/// prediction of the end.
inline constexpr Tableau<2> heun_tableau{
    .a = {{{0, 0}, {1, 0}}},
    .b = {1. / 2, 1. / 2},
    .order = 2,
};
static_assert(proven<heun_tableau>());

struct heun : ForAnyProblem, ExplicitRungeKuttaMethod<heun_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "heun",
       .source = "Heun 1900; Runge 1895; Butcher, Numerical Methods for ODEs, table 232(I)"});
};

}  // namespace odeum::methods
