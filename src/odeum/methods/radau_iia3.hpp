// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/fully_implicit_rk.hpp"

namespace odeum::methods {

/// Radau IIA of two stages: L-stable.
inline constexpr Tableau<2> radau_iia3_tableau = collocation<2>(radau_right_nodes<2>(), 3);
static_assert(collocation_proven(radau_iia3_tableau, 2, 1));
static_assert(proven<radau_iia3_tableau>());

struct radau_iia3 : FullyImplicitMethod<radau_iia3_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "radau_iia3",
       .source = "Ehle 1969, Axelsson 1969; Hairer, Wanner, Solving ODEs II, table IV.5.5"});
};

}  // namespace odeum::methods
