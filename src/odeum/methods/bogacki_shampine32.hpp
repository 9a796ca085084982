// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Bogacki and Shampine's pair: the solution has order 3, the embedded row order 2. First same as
/// last.
inline constexpr Tableau<4> bogacki_shampine32_tableau{
    .a = {{{0}, {1. / 2}, {0, 3. / 4}, {2. / 9, 1. / 3, 4. / 9}}},
    .b = {2. / 9, 1. / 3, 4. / 9},
    .order = 3,
    .b_hat = {7. / 24, 1. / 4, 1. / 3, 1. / 8},
    .order_hat = 2,
};
static_assert(proven<bogacki_shampine32_tableau>());

struct bogacki_shampine32 : ForAnyProblem, ExplicitRungeKuttaMethod<bogacki_shampine32_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "bogacki_shampine32",
       .source = "Bogacki, Shampine, Appl. Math. Lett. 2 (1989) 321-325, the pair (3), (2)"});
};

}  // namespace odeum::methods
