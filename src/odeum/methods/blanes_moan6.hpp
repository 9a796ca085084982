// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/splitting.hpp"

namespace odeum::methods {

/// Blanes and Moan's method of order 6 for q'' = a(t, q): eleven evaluations of a per step (the
/// last is reused by the next step), symmetric.
inline constexpr Splitting<12> blanes_moan6_splitting{
    .kick = {0.0414649985182624, 0.198128671918067, -0.0400061921041533, 0.0752539843015807,
             -0.0115113874206879, 0.2366699247869311, 0.2366699247869311, -0.0115113874206879,
             0.0752539843015807, -0.0400061921041533, 0.198128671918067, 0.0414649985182624},
    .drift = {0.123229775946271, 0.290553797799558, -0.127049212625417, -0.246331761062075,
              0.357208872795928, 0.20477705429147, 0.357208872795928, -0.246331761062075,
              -0.127049212625417, 0.290553797799558, 0.123229775946271, 0.0},
    .order = 6};
static_assert(proven<blanes_moan6_splitting>() && blanes_moan6_splitting.symmetric());

struct blanes_moan6 : SplittingMethod<blanes_moan6_splitting> {
  static constexpr MethodInfo info = described(
      {.id = "blanes_moan6",
       .source = "Blanes, Moan, J. Comput. Appl. Math. 142 (2002) 313-330, table 3, SRKN_11^b"});
  static constexpr auto inlined = Inlined::nonstiff;
};

}  // namespace odeum::methods
