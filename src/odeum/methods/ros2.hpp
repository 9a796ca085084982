// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <numbers>

#include "odeum/kernel/rosenbrock.hpp"

namespace odeum::methods {

/// Verwer's ROS2, L-stable. gamma is the smaller of the two possible values, which gives the
/// smaller error constant.
inline constexpr double ros2_gamma = 1 - std::numbers::sqrt2 / 2;
inline constexpr RosenbrockTableau<2> ros2_tableau =
    rosenbrock_from<2>({{{0, 0}, {1, 0}}}, {{{ros2_gamma, 0}, {-2 * ros2_gamma, ros2_gamma}}},
                       {1. / 2, 1. / 2}, 2, {1, 0}, 1);
static_assert(proven<ros2_tableau>());

struct ros2 : ForAnyProblem, RosenbrockMethod<ros2_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "ros2",
       .control = Control::predictive,
       .source =
           "Verwer, Spee, Blom, Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456-1480, (2.6)"});
};

}  // namespace odeum::methods
