// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// McLachlan and Atela's splitting of order 2 with the smallest error constants: two kicks, two
/// drifts, not symmetric.
inline constexpr Splitting<2> mclachlan_atela2_splitting{
    .kick = {0.29289321881345247560, 0.70710678118654752440},
    .drift = {0.70710678118654752440, 0.29289321881345247560},
    .order = 2};
static_assert(proven<mclachlan_atela2_splitting>());

struct mclachlan_atela2 : SplittingMethod<mclachlan_atela2_splitting> {
  static constexpr MethodInfo info =
      described({.id = "mclachlan_atela2",
                 .source = "McLachlan, Atela, Nonlinearity 5 (1992) 541-562, table 2"});
};

}  // namespace odeum::methods
