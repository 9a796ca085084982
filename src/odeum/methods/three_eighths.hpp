// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Kutta's 3/8 rule: on y' = f(t) Newton's quadrature rule of that name.
inline constexpr Tableau<4> three_eighths_tableau{
    .a = {{{0}, {1. / 3}, {-1. / 3, 1}, {1, -1, 1}}},
    .b = {1. / 8, 3. / 8, 3. / 8, 1. / 8},
    .order = 4,
};
static_assert(proven<three_eighths_tableau>());

struct three_eighths : ForAnyProblem, ExplicitRungeKuttaMethod<three_eighths_tableau> {
  static constexpr MethodInfo info =
      described({.id = "three_eighths",
                 .source = "Kutta 1901; Hairer, Norsett, Wanner, Solving ODEs I, table II.1.2"});
};

}  // namespace odeum::methods
