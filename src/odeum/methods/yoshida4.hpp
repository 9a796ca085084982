// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// Yoshida's composition of order 4 (also Forest and Ruth, Suzuki): three velocity-Verlet steps of
/// lengths w_1, w_0, w_1 with w_1 = 1 / (2 - 2^(1/3)), the middle one backwards.
inline constexpr Splitting<4> yoshida4_splitting =
    compose_verlet(around_the_middle<1>({1 / (2 - 1.2599210498948731648)}), 4);
static_assert(proven<yoshida4_splitting>() && yoshida4_splitting.symmetric());

struct yoshida4 : SplittingMethod<yoshida4_splitting> {
  static constexpr MethodInfo info =
      described({.id = "yoshida4", .source = "Yoshida, Phys. Lett. A 150 (1990) 262-268, (2.11)"});
};

}  // namespace odeum::methods
