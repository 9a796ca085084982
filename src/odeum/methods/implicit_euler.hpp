// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/diagonally_implicit_rk.hpp"

namespace odeum::methods {

/// Implicit (backward) Euler: y_{n+1} = y_n + h f(t_{n+1}, y_{n+1}).
inline constexpr Tableau<1> implicit_euler_tableau{
    .a = {{{1}}},
    .b = {1},
    .order = 1,
};
static_assert(proven<implicit_euler_tableau>());

struct implicit_euler : ForAnyProblem, DiagonallyImplicitMethod<implicit_euler_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "implicit_euler",
       .common_use = CommonUse::engine,
       .source =
           "Cauchy 1824; Hairer, Wanner, Solving ODEs II, (IV.1.2); Newton's method as in IV.8"});
};

}  // namespace odeum::methods
