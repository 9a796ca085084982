// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/diagonally_implicit_rk.hpp"

namespace odeum::methods {

/// The implicit midpoint rule, Gauss's method of one stage: symplectic, reversible, A-stable, and
/// exact for quadratic invariants.
inline constexpr Tableau<1> implicit_midpoint_tableau{
    .a = {{{1. / 2}}},
    .b = {1},
    .order = 2,
};
static_assert(proven<implicit_midpoint_tableau>());

struct implicit_midpoint : ForAnyProblem, DiagonallyImplicitMethod<implicit_midpoint_tableau> {
  static constexpr MethodInfo info =
      described({.id = "implicit_midpoint",
                 .common_use = CommonUse::fixed_step,
                 .source = "Hairer, Wanner, Solving ODEs II, (IV.3.5), table IV.5.1"});
};

}  // namespace odeum::methods
