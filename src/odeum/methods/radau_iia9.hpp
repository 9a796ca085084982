// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/radau_control.hpp"

namespace odeum::methods {

/// Radau IIA of five stages: L-stable. Adaptive with an estimate of order 5.
inline constexpr Tableau<5> radau_iia9_tableau = collocation<5>(radau_right_nodes<5>(), 9);
static_assert(collocation_proven(radau_iia9_tableau, 5, 4));

struct radau_iia9 : RadauMethod<radau_iia9_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "radau_iia9",
       .controller = "embedded estimate of order 5, predictive",
       .source =
           "Hairer, Wanner, J. Comput. Appl. Math. 111 (1999) 93-111; Solving ODEs II, IV.8"});
  static constexpr auto inlined = Inlined::stiff;
};

}  // namespace odeum::methods
