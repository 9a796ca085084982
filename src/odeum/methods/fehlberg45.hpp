// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Fehlberg's 4(5) pair as published: the solution has order 4, the row of order 5 only estimates
/// the error (no local extrapolation).
inline constexpr Tableau<6> fehlberg45_tableau{
    .a = {{{0},
           {1. / 4},
           {3. / 32, 9. / 32},
           {1932. / 2197, -7200. / 2197, 7296. / 2197},
           {439. / 216, -8, 3680. / 513, -845. / 4104},
           {-8. / 27, 2, -3544. / 2565, 1859. / 4104, -11. / 40}}},
    .b = {25. / 216, 0, 1408. / 2565, 2197. / 4104, -1. / 5},
    .order = 4,
    .b_hat = {16. / 135, 0, 6656. / 12825, 28561. / 56430, -9. / 50, 2. / 55},
    .order_hat = 5,
};
static_assert(proven<fehlberg45_tableau>());

struct fehlberg45 : ForAnyProblem, ExplicitRungeKuttaMethod<fehlberg45_tableau> {
  static constexpr MethodInfo info =
      described({.id = "fehlberg45",
                 .source = "Fehlberg, NASA TR R-315 (1969), table III; Hairer, "
                           "Norsett, Wanner, Solving ODEs I, table II.5.1"});
};

}  // namespace odeum::methods
