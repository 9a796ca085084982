// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"
#include "odeum/methods/cash_karp54.hpp"

namespace odeum::methods {

/// Cash and Karp's weights of order 2 on their six stages, as a method of its own.
inline constexpr Tableau<6> cash_karp54_order2_tableau =
    cash_karp54_tableau.with_row({-3. / 2, 5. / 2, 0, 0, 0, 0}, 2);
static_assert(proven<cash_karp54_order2_tableau>());

struct cash_karp54_order2 : ForAnyProblem, ExplicitRungeKuttaMethod<cash_karp54_order2_tableau> {
  static constexpr MethodInfo info =
      described({.id = "cash_karp54_order2",
                 .source = "Cash, Karp, ACM TOMS 16 (1990) 201-222, table in section 2"});
};

}  // namespace odeum::methods
