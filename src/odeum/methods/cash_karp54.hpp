// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Cash and Karp's embedded pair. The paper gives a row of weights for each order from 5 to 1 on
/// the same six stages; the pair advances with order 5 and estimates the error with order 4, and
/// each lower order is a method of its own (cash_karp54_order4, ..., cash_karp54_order1).
inline constexpr Tableau<6> cash_karp54_tableau{
    .a = {{{0, 0, 0, 0, 0, 0},
           {1. / 5, 0, 0, 0, 0, 0},
           {3. / 40, 9. / 40, 0, 0, 0, 0},
           {3. / 10, -9. / 10, 6. / 5, 0, 0, 0},
           {-11. / 54, 5. / 2, -70. / 27, 35. / 27, 0, 0},
           {1631. / 55296, 175. / 512, 575. / 13824, 44275. / 110592, 253. / 4096, 0}}},
    .b = {37. / 378, 0, 250. / 621, 125. / 594, 0, 512. / 1771},
    .order = 5,
    .b_hat = {2825. / 27648, 0, 18575. / 48384, 13525. / 55296, 277. / 14336, 1. / 4},
    .order_hat = 4,
};
static_assert(proven<cash_karp54_tableau>());

struct cash_karp54 : ForAnyProblem, ExplicitRungeKuttaMethod<cash_karp54_tableau> {
  static constexpr MethodInfo info =
      described({.id = "cash_karp54",
                 .source = "Cash, Karp, ACM TOMS 16 (1990) 201-222, table in section 2"});
};

}  // namespace odeum::methods
