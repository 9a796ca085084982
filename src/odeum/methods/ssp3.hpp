// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Shu and Osher's three stages of order 3, strong-stability-preserving with coefficient 1: each
/// stage is a convex combination of Euler steps.
inline constexpr Tableau<3> ssp3_tableau{
    .a = {{{0}, {1}, {1. / 4, 1. / 4}}},
    .b = {1. / 6, 1. / 6, 2. / 3},
    .order = 3,
};
static_assert(proven<ssp3_tableau>());

struct ssp3 : ForAnyProblem, ExplicitRungeKuttaMethod<ssp3_tableau> {
  static constexpr MethodInfo info =
      described({.id = "ssp3", .source = "Shu, Osher, J. Comput. Phys. 77 (1988) 439-471, (2.18)"});
};

}  // namespace odeum::methods
