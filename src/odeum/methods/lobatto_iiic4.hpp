// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/fully_implicit_rk.hpp"

namespace odeum::methods {

/// Lobatto IIIC of three stages: L-stable; both ends of the step are nodes.
inline constexpr Tableau<3> lobatto_iiic4_tableau{
    .a = {{{1. / 6, -1. / 3, 1. / 6}, {1. / 6, 5. / 12, -1. / 12}, {1. / 6, 2. / 3, 1. / 6}}},
    .b = {1. / 6, 2. / 3, 1. / 6},
    .order = 4,
};
static_assert(proven<lobatto_iiic4_tableau>());
static_assert(collocation_proven(lobatto_iiic4_tableau, 2, 2));

struct lobatto_iiic4 : FullyImplicitMethod<lobatto_iiic4_tableau> {
  static constexpr MethodInfo info =
      described({.id = "lobatto_iiic4",
                 .source = "Chipman 1971; Hairer, Wanner, Solving ODEs II, table IV.5.11"});
};

}  // namespace odeum::methods
