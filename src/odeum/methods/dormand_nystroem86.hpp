// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/nystroem.hpp"

namespace odeum::methods {

/// Dormand, El-Mikkawy and Prince's pair 8(6) for q'' = a(t, q): nine stages, first same as last.
/// The solution has order 8, the embedded row order 6.
inline constexpr NystroemTableau<9> dormand_nystroem86_tableau{
    .c = {0, 1. / 20, 1. / 10, 3. / 10, 1. / 2, 7. / 10, 9. / 10, 1, 1},
    .a = {{{0},
           {1. / 800},
           {1. / 600, 1. / 300},
           {9. / 200, -9. / 100, 9. / 100},
           {-66701. / 197352, 28325. / 32892, -2665. / 5482, 2170. / 24669},
           {227015747. / 304251000, -54897451. / 30425100, 12942349. / 10141700, -9499. / 304251,
            539. / 9250},
           {-1131891597. / 901789000, 41964921. / 12882700, -6663147. / 3220675, 270954. / 644135,
            -108. / 5875, 114. / 1645},
           {13836959. / 3667458, -17731450. / 1833729, 1063919505. / 156478208,
            -33213845. / 39119552, 13335. / 28544, -705. / 14272, 1645. / 57088},
           {223. / 7938, 0, 1175. / 8064, 925. / 6048, 41. / 448, 925. / 14112, 1175. / 72576}}},
    .b_q = {223. / 7938, 0, 1175. / 8064, 925. / 6048, 41. / 448, 925. / 14112, 1175. / 72576, 0,
            0},
    .b_v = {223. / 7938, 0, 5875. / 36288, 4625. / 21168, 41. / 224, 4625. / 21168, 5875. / 36288,
            223. / 7938, 0},
    .order = 8,
    .b_q_hat = {7987313. / 109941300, 0, 1610737. / 44674560, 10023263. / 33505920,
                -497221. / 12409600, 10023263. / 78180480, 1610737. / 402071040, 0, 0},
    .b_v_hat = {7987313. / 109941300, 0, 1610737. / 40207104, 10023263. / 23454144,
                -497221. / 6204800, 10023263. / 23454144, 1610737. / 40207104, -4251941. / 54970650,
                3. / 20},
    .order_hat = 6};
static_assert(proven<dormand_nystroem86_tableau>() && dormand_nystroem86_tableau.is_explicit() &&
              dormand_nystroem86_tableau.reuses_last_stage());

struct dormand_nystroem86 : NystroemMethod<dormand_nystroem86_tableau> {
  static constexpr bool misses_kinks = true, sees_ends = true;
  static constexpr MethodInfo info = described(
      {.id = "dormand_nystroem86",
       .source = "Dormand, El-Mikkawy, Prince, IMA J. Numer. Anal. 7 (1987) 423-430, RKN8(6)9FM"});
  static constexpr auto inlined = Inlined::nonstiff;
};

}  // namespace odeum::methods
