// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// McLachlan and Atela's splitting of order 4 with the smallest error constants: four kicks, four
/// drifts, not symmetric.
inline constexpr Splitting<4> mclachlan_atela4_splitting{
    .kick = {0.134496199277431089, -0.224819803079420806, 0.756320000515668291,
             0.334003603286321425},
    .drift = {0.515352837431122936, -0.085782019412973646, 0.441583023616466524,
              0.128846158365384185},
    .order = 4};
static_assert(proven<mclachlan_atela4_splitting>());

struct mclachlan_atela4 : SplittingMethod<mclachlan_atela4_splitting> {
  static constexpr MethodInfo info =
      described({.id = "mclachlan_atela4",
                 .source = "McLachlan, Atela, Nonlinearity 5 (1992) 541-562, table 2"});
};

}  // namespace odeum::methods
