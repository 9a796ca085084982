// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <numbers>

#include "odeum/kernel/diagonally_implicit_rk.hpp"

namespace odeum::methods {

/// The L-stable singly diagonally implicit method of two stages; gamma is the smaller root of
/// gamma^2 - 2 gamma + 1/2, which gives the smaller error constant.
inline constexpr double sdirk2_gamma = 1 - std::numbers::sqrt2 / 2;
inline constexpr Tableau<2> sdirk2_tableau{
    .a = {{{sdirk2_gamma, 0}, {1 - sdirk2_gamma, sdirk2_gamma}}},
    .b = {1 - sdirk2_gamma, sdirk2_gamma},
    .order = 2,
};
static_assert(proven<sdirk2_tableau>());

struct sdirk2 : ForAnyProblem, DiagonallyImplicitMethod<sdirk2_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "sdirk2",
       .source =
           "Alexander, SIAM J. Numer. Anal. 14 (1977) 1006-1021; Solving ODEs II, (IV.6.16)"});
};

}  // namespace odeum::methods
