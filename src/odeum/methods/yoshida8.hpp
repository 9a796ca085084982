// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// Yoshida's composition of order 8: fifteen velocity-Verlet steps, solution D. Digits beyond those
/// published follow from the order conditions.
inline constexpr Splitting<16> yoshida8_splitting = compose_verlet(
    around_the_middle<7>({0.1027998493917964407, -1.9606102329753108076, 1.9381391376225259866,
                          -0.1582406353680501752, -1.4448522368606051577, 0.25369333656621135415,
                          0.91484424622979156675}),
    8);
static_assert(proven<yoshida8_splitting>() && yoshida8_splitting.symmetric());

struct yoshida8 : SplittingMethod<yoshida8_splitting> {
  static constexpr MethodInfo info =
      described({.id = "yoshida8",
                 .source = "Yoshida, Phys. Lett. A 150 (1990) 262-268, table 2, solution D"});
};

}  // namespace odeum::methods
