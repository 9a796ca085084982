// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"
#include "odeum/methods/cash_karp54.hpp"

namespace odeum::methods {

/// Cash and Karp's weights of order 3 on their six stages, as a method of its own.
inline constexpr Tableau<6> cash_karp54_order3_tableau =
    cash_karp54_tableau.with_row({19. / 54, 0, -10. / 27, 55. / 54, 0, 0}, 3);
static_assert(proven<cash_karp54_order3_tableau>());

struct cash_karp54_order3 : ForAnyProblem, ExplicitRungeKuttaMethod<cash_karp54_order3_tableau> {
  static constexpr bool misses_kinks = true;
  static constexpr MethodInfo info =
      described({.id = "cash_karp54_order3",
                 .source = "Cash, Karp, ACM TOMS 16 (1990) 201-222, table in section 2"});
};

}  // namespace odeum::methods
