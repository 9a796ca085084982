// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/radau_control.hpp"

namespace odeum::methods {

/// Radau IIA of three stages: L-stable. Adaptive with an estimate of order 3.
inline constexpr Tableau<3> radau_iia5_tableau = collocation<3>(radau_right_nodes<3>(), 5);
static_assert(collocation_proven(radau_iia5_tableau, 3, 2));
static_assert(proven<radau_iia5_tableau>());

struct radau_iia5 : RadauMethod<radau_iia5_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "radau_iia5",
       .controller = "embedded estimate of order 3, predictive",
       .source = "Ehle 1969; Hairer, Wanner, Solving ODEs II, table IV.5.6 and section IV.8"});
  static constexpr auto inlined = Inlined::stiff;
};

}  // namespace odeum::methods
