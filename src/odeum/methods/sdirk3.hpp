// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/diagonally_implicit_rk.hpp"

namespace odeum::methods {

/// Alexander's L-stable method of three stages and order 3. gamma is the root of
/// x^3 - 3 x^2 + 3/2 x - 1/6 in (1/6, 1/2).
inline constexpr double sdirk3_gamma = 0.43586652150845899942;
inline constexpr double sdirk3_b1 = (-6 * sdirk3_gamma * sdirk3_gamma + 16 * sdirk3_gamma - 1) / 4;
inline constexpr double sdirk3_b2 = (6 * sdirk3_gamma * sdirk3_gamma - 20 * sdirk3_gamma + 5) / 4;
inline constexpr Tableau<3> sdirk3_tableau{
    .a = {{{sdirk3_gamma, 0, 0},
           {(1 - sdirk3_gamma) / 2, sdirk3_gamma, 0},
           {sdirk3_b1, sdirk3_b2, sdirk3_gamma}}},
    .b = {sdirk3_b1, sdirk3_b2, sdirk3_gamma},
    .order = 3,
};
static_assert(proven<sdirk3_tableau>());

struct sdirk3 : ForAnyProblem, DiagonallyImplicitMethod<sdirk3_tableau> {
  static constexpr bool misses_kinks = true;
  static constexpr MethodInfo info = described(
      {.id = "sdirk3", .source = "Alexander, SIAM J. Numer. Anal. 14 (1977) 1006-1021, theorem 5"});
};

}  // namespace odeum::methods
