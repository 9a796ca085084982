// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// McLachlan and Atela's splitting of order 3 with the smallest error constants: three kicks and
/// the same drifts in reverse order, not symmetric. Digits beyond those published follow from the
/// order conditions.
inline constexpr Splitting<3> mclachlan_atela3_splitting{
    .kick = {0.26833009578175992496, -0.18799161879915978201, 0.91966152301739985705},
    .drift = {0.91966152301739985705, -0.18799161879915978201, 0.26833009578175992496},
    .order = 3};
static_assert(proven<mclachlan_atela3_splitting>());

struct mclachlan_atela3 : SplittingMethod<mclachlan_atela3_splitting> {
  static constexpr MethodInfo info =
      described({.id = "mclachlan_atela3",
                 .source = "McLachlan, Atela, Nonlinearity 5 (1992) 541-562, table 2"});
};

}  // namespace odeum::methods
