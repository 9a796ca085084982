// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <numbers>

#include "odeum/kernel/rosenbrock.hpp"

namespace odeum::methods {

/// Lang and Verwer's ROS3P: A-stable, order 3 without reduction on parabolic problems. On linear
/// problems its embedded row gives the same result as the main row, and so an estimate of zero for
/// any step: adaptive runs use step doubling.
inline constexpr double ros3p_gamma = 1. / 2 + std::numbers::sqrt3 / 6;
inline constexpr RosenbrockTableau<3> ros3p_tableau =
    rosenbrock_from<3>({{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}},
                       {{{ros3p_gamma, 0, 0},
                         {-1, ros3p_gamma, 0},
                         {-ros3p_gamma, 1. / 2 - 2 * ros3p_gamma, ros3p_gamma}}},
                       {2. / 3, 0, 1. / 3}, 3, {1. / 3, 1. / 3, 1. / 3}, 2);
static_assert(proven<ros3p_tableau>());

struct ros3p : ForAnyProblem, RosenbrockMethod<ros3p_tableau> {
  static constexpr MethodInfo info{.id = "ros3p",
                                   .family = "linearly_implicit",
                                   .order = ros3p_tableau.order,
                                   .source = "Lang, Verwer, BIT 41 (2001) 731-738, table 1"};
};

}  // namespace odeum::methods
