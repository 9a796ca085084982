// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/diagonally_implicit_rk.hpp"

namespace odeum::methods {

/// Hairer and Wanner's L-stable pair of five stages, gamma = 1/4.
inline constexpr Tableau<5> sdirk4_tableau{
    .a = {{{1. / 4, 0, 0, 0, 0},
           {1. / 2, 1. / 4, 0, 0, 0},
           {17. / 50, -1. / 25, 1. / 4, 0, 0},
           {371. / 1360, -137. / 2720, 15. / 544, 1. / 4, 0},
           {25. / 24, -49. / 48, 125. / 16, -85. / 12, 1. / 4}}},
    .b = {25. / 24, -49. / 48, 125. / 16, -85. / 12, 1. / 4},
    .order = 4,
    .b_hat = {59. / 48, -17. / 96, 225. / 32, -85. / 12, 0},
    .order_hat = 3,
};
static_assert(proven<sdirk4_tableau>());

struct sdirk4 : ForAnyProblem, DiagonallyImplicitMethod<sdirk4_tableau> {
  static constexpr bool leaves_out_ends = true;
  static constexpr bool misses_kinks = true;
  static constexpr MethodInfo info =
      described({.id = "sdirk4",
                 .control = Control::predictive,
                 .source = "Hairer, Wanner, Solving ODEs II, table IV.6.5"});
};

}  // namespace odeum::methods
