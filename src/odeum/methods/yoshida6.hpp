// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// Yoshida's composition of order 6: seven velocity-Verlet steps, solution A. Digits beyond those
/// published follow from the order conditions.
inline constexpr Splitting<8> yoshida6_splitting = compose_verlet(
    around_the_middle<3>({-1.1776799841788710069, 0.23557321335935813368, 0.78451361047755726382}),
    6);
static_assert(proven<yoshida6_splitting>() && yoshida6_splitting.symmetric());

struct yoshida6 : SplittingMethod<yoshida6_splitting> {
  static constexpr MethodInfo info =
      described({.id = "yoshida6",
                 .source = "Yoshida, Phys. Lett. A 150 (1990) 262-268, table 1, solution A"});
};

}  // namespace odeum::methods
