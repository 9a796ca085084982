// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// The classical Runge-Kutta method.
inline constexpr Tableau<4> rk4_tableau{
    .a = {{{0, 0, 0, 0}, {1. / 2, 0, 0, 0}, {0, 1. / 2, 0, 0}, {0, 0, 1, 0}}},
    .b = {1. / 6, 1. / 3, 1. / 3, 1. / 6},
    .order = 4,
};
static_assert(proven<rk4_tableau>());

struct rk4 : ForAnyProblem, ExplicitRungeKuttaMethod<rk4_tableau> {
  static constexpr MethodInfo info =
      described({.id = "rk4",
                 .common_use = CommonUse::fixed_step,
                 .source = "Kutta 1901; Hairer, Norsett, Wanner, Solving ODEs I, table II.1.2"});
  static constexpr auto inlined = Inlined::nonstiff;
};

}  // namespace odeum::methods
