// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Explicit (forward) Euler: y_{n+1} = y_n + h f(t_n, y_n).
inline constexpr Tableau<1> explicit_euler_tableau{
    .a = {{{0}}},
    .b = {1},
    .order = 1,
};
static_assert(proven<explicit_euler_tableau>());

struct explicit_euler : ForAnyProblem, ExplicitRungeKuttaMethod<explicit_euler_tableau> {
  static constexpr MethodInfo info =
      described({.id = "explicit_euler",
                 .source = "Euler 1768; Hairer, Norsett, Wanner, Solving ODEs I, (I.7.3)"});
};

}  // namespace odeum::methods
