// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// Blanes and Moan's method of order 4 for q'' = a(t, q): six evaluations of a per step (the last
/// is reused by the next step), symmetric.
inline constexpr Splitting<7> blanes_moan4_splitting{
    .kick = {0.0829844064174052, 0.396309801498368, -0.0390563049223486, 0.1195241940131508,
             -0.0390563049223486, 0.396309801498368, 0.0829844064174052},
    .drift = {0.245298957184271, 0.60487266571108, -0.350171622895351, -0.350171622895351,
              0.60487266571108, 0.245298957184271, 0.0},
    .order = 4};
static_assert(proven<blanes_moan4_splitting>() && blanes_moan4_splitting.symmetric());

struct blanes_moan4 : SplittingMethod<blanes_moan4_splitting> {
  static constexpr MethodInfo info = described(
      {.id = "blanes_moan4",
       .source = "Blanes, Moan, J. Comput. Appl. Math. 142 (2002) 313-330, table 3, SRKN_6^b"});
};

}  // namespace odeum::methods
