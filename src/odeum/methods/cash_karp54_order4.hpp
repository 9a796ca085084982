// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"
#include "odeum/methods/cash_karp54.hpp"

namespace odeum::methods {

/// Cash and Karp's weights of order 4 on their six stages, as a method of its own.
inline constexpr Tableau<6> cash_karp54_order4_tableau =
    cash_karp54_tableau.with_row(cash_karp54_tableau.b_hat, 4);
static_assert(proven<cash_karp54_order4_tableau>());

struct cash_karp54_order4 : ForAnyProblem, ExplicitRungeKuttaMethod<cash_karp54_order4_tableau> {
  static constexpr MethodInfo info =
      described({.id = "cash_karp54_order4",
                 .source = "Cash, Karp, ACM TOMS 16 (1990) 201-222, table in section 2"});
};

}  // namespace odeum::methods
