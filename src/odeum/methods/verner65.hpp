// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Verner's pair 6(5) of nine stages, the one that he calls most robust: the solution has order 6,
/// the embedded row order 5. First same as last. His most efficient one has weights of size 1e4,
/// whose rounding to double violates the condition of order 2 by 6e-12.
inline constexpr Tableau<9> verner65_tableau{
    .a = {{{0},
           {9. / 50},
           {29. / 324, 25. / 324},
           {1. / 16, 0, 3. / 16},
           {79129. / 250000, 0, -261237. / 250000, 19663. / 15625},
           {1336883. / 4909125, 0, -25476. / 30875, 194159. / 185250, 8225. / 78546},
           {-0.16699418599716514314, 0, 19504. / 30875, 0.17461044552773876082, -6157250. / 5773131,
            902. / 735},
           {2699. / 7410, 0, -252. / 1235, -1393253. / 3993990, 236875. / 72618, -135. / 49,
            15. / 22},
           {11. / 144, 0, 0, 256. / 693, 0, 125. / 504, 125. / 528, 5. / 72}}},
    .b = {11. / 144, 0, 0, 256. / 693, 0, 125. / 504, 125. / 528, 5. / 72},
    .order = 6,
    .b_hat = {28. / 477, 0, 0, 212. / 441, -312500. / 366177, 2125. / 1764, 0, -2105. / 35532,
              2995. / 17766},
    .order_hat = 5,
};
static_assert(proven<verner65_tableau>());

struct verner65 : ForAnyProblem, ExplicitRungeKuttaMethod<verner65_tableau> {
  static constexpr MethodInfo info =
      described({.id = "verner65",
                 .source = "Verner, Numer. Algorithms 53 (2010) 383-396; his page of "
                           "pairs, RKV65.IIIXb.Robust.00010102836"});
};

}  // namespace odeum::methods
