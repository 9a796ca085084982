// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/fully_implicit_rk.hpp"

namespace odeum::methods {

/// Gauss's method of two stages: symplectic, reversible, A-stable.
inline constexpr Tableau<2> gauss4_tableau = collocation<2>(gauss_nodes<2>(), 4);
static_assert(collocation_proven(gauss4_tableau, 2, 2));
static_assert(proven<gauss4_tableau>());

struct gauss4 : FullyImplicitMethod<gauss4_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "gauss4",
       .source = "Hammer, Hollingsworth 1955; Hairer, Wanner, Solving ODEs II, table IV.5.1"});
};

}  // namespace odeum::methods
