// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/diagonally_implicit_rk.hpp"

namespace odeum::methods {

/// The trapezoidal rule, Lobatto IIIA of two stages: A-stable, not L-stable (R -> -1 at infinity).
inline constexpr Tableau<2> trapezoidal_tableau{
    .a = {{{0, 0}, {1. / 2, 1. / 2}}},
    .b = {1. / 2, 1. / 2},
    .order = 2,
};
static_assert(proven<trapezoidal_tableau>());

struct trapezoidal : ForAnyProblem, DiagonallyImplicitMethod<trapezoidal_tableau> {
  static constexpr MethodInfo info =
      described({.id = "trapezoidal",
                 .source = "Crank, Nicolson 1947; Hairer, Wanner, Solving ODEs II, (IV.3.4)"});
};

}  // namespace odeum::methods
