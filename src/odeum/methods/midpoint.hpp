// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// The explicit midpoint rule: f at the middle of the step, predicted by half an Euler step.
inline constexpr Tableau<2> midpoint_tableau{
    .a = {{{0, 0}, {1. / 2, 0}}},
    .b = {0, 1},
    .order = 2,
};
static_assert(proven<midpoint_tableau>());

struct midpoint : ForAnyProblem, ExplicitRungeKuttaMethod<midpoint_tableau> {
  static constexpr MethodInfo info =
      described({.id = "midpoint",
                 .source = "Runge 1895; Hairer, Norsett, Wanner, Solving ODEs I, (II.1.4)"});
};

}  // namespace odeum::methods
