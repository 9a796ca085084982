// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Kutta's method of order 3.
inline constexpr Tableau<3> kutta3_tableau{
    .a = {{{0}, {1. / 2}, {-1, 2}}},
    .b = {1. / 6, 2. / 3, 1. / 6},
    .order = 3,
};
static_assert(proven<kutta3_tableau>());

struct kutta3 : ForAnyProblem, ExplicitRungeKuttaMethod<kutta3_tableau> {
  static constexpr MethodInfo info =
      described({.id = "kutta3",
                 .source = "Kutta, Z. Math. Phys. 46 (1901) 435-453; Hairer, Norsett, Wanner, "
                           "Solving ODEs I, II.1"});
};

}  // namespace odeum::methods
