// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/additive_rk.hpp"
#include "odeum/methods/esdirk43.hpp"

namespace odeum::methods {

/// Kennedy and Carpenter's ARK4(3)6L[2]SA, whose implicit half is esdirk43; both halves share their
/// weights.
inline constexpr AdditiveTableau<6> ark43_kennedy_carpenter_tableau{
    .explicit_half = {.a = {{{0},
                             {1. / 2},
                             {13861. / 62500, 6889. / 62500},
                             {-116923316275. / 2393684061468, -2731218467317. / 15368042101831,
                              9408046702089. / 11113171139209},
                             {-451086348788. / 2902428689909, -2682348792572. / 7519795681897,
                              12662868775082. / 11960479115383, 3355817975965. / 11060851509271},
                             {647845179188. / 3216320057751, 73281519250. / 8382639484533,
                              552539513391. / 3454668386233, 3354512671639. / 8306763924573,
                              4040. / 17871}}},
                      .b = esdirk43_tableau.b,
                      .b_hat = esdirk43_tableau.b_hat},
    .implicit_half = esdirk43_tableau,
    .order = 4,
    .order_hat = 3,
};
static_assert(proven<ark43_kennedy_carpenter_tableau>());

struct ark43_kennedy_carpenter : ForSplit, AdditiveMethod<ark43_kennedy_carpenter_tableau> {
  static constexpr MethodInfo info =
      described({.id = "ark43_kennedy_carpenter",
                 .control = Control::predictive,
                 .source = "Kennedy, Carpenter, Appl. Numer. Math. 44 (2003) 139-181, "
                           "tables for ARK4(3)6L[2]SA"});
};

}  // namespace odeum::methods
