// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/fully_implicit_rk.hpp"

namespace odeum::methods {

/// Gauss's method of three stages: symplectic, reversible, A-stable.
inline constexpr Tableau<3> gauss6_tableau = collocation<3>(gauss_nodes<3>(), 6);
static_assert(collocation_proven(gauss6_tableau, 3, 3));
static_assert(proven<gauss6_tableau>());

struct gauss6 : FullyImplicitMethod<gauss6_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "gauss6",
       .source = "Kuntzmann 1961, Butcher 1964; Hairer, Wanner, Solving ODEs II, table IV.5.2"});
};

}  // namespace odeum::methods
