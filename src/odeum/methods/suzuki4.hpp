// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// Suzuki's composition of order 4: five velocity-Verlet steps, four of length p h around a
/// backward one of (1 - 4 p) h, p = 1 / (4 - 4^(1/3)). Smaller errors than three steps (yoshida4),
/// since the backward step is shorter.
inline constexpr Splitting<6> suzuki4_splitting = compose_verlet(
    around_the_middle<2>({1 / (4 - 1.5874010519681994748), 1 / (4 - 1.5874010519681994748)}), 4);
static_assert(proven<suzuki4_splitting>() && suzuki4_splitting.symmetric());

struct suzuki4 : SplittingMethod<suzuki4_splitting> {
  static constexpr MethodInfo info =
      described({.id = "suzuki4",
                 .source = "Suzuki, Phys. Lett. A 146 (1990) 319-323; Hairer, Lubich, "
                           "Wanner, Geometric Numerical Integration, (II.4.5)"});
};

}  // namespace odeum::methods
