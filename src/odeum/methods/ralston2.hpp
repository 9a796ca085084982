// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Ralston's method of order 2: the two stages with the smallest bound on the local error.
inline constexpr Tableau<2> ralston2_tableau{
    .a = {{{0}, {2. / 3}}},
    .b = {1. / 4, 3. / 4},
    .order = 2,
};
static_assert(proven<ralston2_tableau>());

struct ralston2 : ForAnyProblem, ExplicitRungeKuttaMethod<ralston2_tableau> {
  static constexpr MethodInfo info =
      described({.id = "ralston2", .source = "Ralston, Math. Comp. 16 (1962) 431-437, section 3"});
};

}  // namespace odeum::methods
