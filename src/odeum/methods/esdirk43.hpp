// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/diagonally_implicit_rk.hpp"

namespace odeum::methods {

/// The implicit half of Kennedy and Carpenter's ARK4(3)6L[2]SA: explicit first stage, stage order
/// 2, L-stable and stiffly accurate, as is its embedded row of order 3.
inline constexpr Tableau<6> esdirk43_tableau{
    .a = {{{0, 0, 0, 0, 0, 0},
           {1. / 4, 1. / 4, 0, 0, 0, 0},
           {8611. / 62500, -1743. / 31250, 1. / 4, 0, 0, 0},
           {5012029. / 34652500, -654441. / 2922500, 174375. / 388108, 1. / 4, 0, 0},
           {15267082809. / 155376265600, -71443401. / 120774400, 730878875. / 902184768,
            2285395. / 8070912, 1. / 4, 0},
           {82889. / 524892, 0, 15625. / 83664, 69875. / 102672, -2260. / 8211, 1. / 4}}},
    .b = {82889. / 524892, 0, 15625. / 83664, 69875. / 102672, -2260. / 8211, 1. / 4},
    .order = 4,
    .b_hat = {4586570599. / 29645900160, 0, 178811875. / 945068544, 814220225. / 1159782912,
              -3700637. / 11593932, 61727. / 225920},
    .order_hat = 3,
};
static_assert(proven<esdirk43_tableau>());

struct esdirk43 : ForAnyProblem, DiagonallyImplicitMethod<esdirk43_tableau> {
  static constexpr MethodInfo info =
      described({.id = "esdirk43",
                 .control = Control::predictive,
                 .source = "Kennedy, Carpenter, Appl. Numer. Math. 44 (2003) 139-181, "
                           "table for ARK4(3)6L[2]SA-ESDIRK"});
};

}  // namespace odeum::methods
