// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/nystroem.hpp"

namespace odeum::methods {

/// Dormand, El-Mikkawy and Prince's pair 6(4) for q'' = a(t, q): six stages, first same as last.
/// The solution has order 6, the embedded row order 4.
inline constexpr NystroemTableau<6> dormand_nystroem64_tableau{
    .c = {0, 1. / 10, 3. / 10, 7. / 10, 17. / 25, 1},
    .a = {{{0},
           {1. / 200},
           {-1. / 2200, 1. / 22},
           {637. / 6600, -7. / 110, 7. / 33},
           {225437. / 1968750, -30073. / 281250, 65569. / 281250, -9367. / 984375},
           {151. / 2142, 5. / 116, 385. / 1368, 55. / 168, -6250. / 28101}}},
    .b_q = {151. / 2142, 5. / 116, 385. / 1368, 55. / 168, -6250. / 28101, 0},
    .b_v = {151. / 2142, 25. / 522, 275. / 684, 275. / 252, -78125. / 112404, 1. / 12},
    .order = 6,
    .b_q_hat = {1349. / 157500, 7873. / 50000, 192199. / 900000, 521683. / 2100000, -16. / 125, 0},
    .b_v_hat = {1349. / 157500, 7873. / 45000, 27457. / 90000, 521683. / 630000, -2. / 5, 1. / 12},
    .order_hat = 4};
static_assert(proven<dormand_nystroem64_tableau>() && dormand_nystroem64_tableau.is_explicit() &&
              dormand_nystroem64_tableau.reuses_last_stage());

struct dormand_nystroem64 : NystroemMethod<dormand_nystroem64_tableau> {
  static constexpr bool misses_kinks = true, sees_ends = true;
  static constexpr MethodInfo info = described(
      {.id = "dormand_nystroem64",
       .source = "Dormand, El-Mikkawy, Prince, IMA J. Numer. Anal. 7 (1987) 235-250, RKN6(4)6FM"});
  static constexpr auto inlined = Inlined::nonstiff;
};

}  // namespace odeum::methods
