// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/rosenbrock.hpp"

namespace odeum::methods {

/// The Rosenbrock method of one stage with gamma = 1: L-stable, order 1. Where
/// implicit_euler_linearised evaluates f at t + h, this one takes f and df/dt at t.
inline constexpr RosenbrockTableau<1> rosenbrock_euler_tableau =
    rosenbrock_from<1>({{{0}}}, {{{1}}}, {1}, 1);
static_assert(proven<rosenbrock_euler_tableau>());

struct rosenbrock_euler : ForAnyProblem, RosenbrockMethod<rosenbrock_euler_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "rosenbrock_euler",
       .source =
           "Rosenbrock, Computer J. 5 (1963) 329-330; Hairer, Wanner, Solving ODEs II, IV.7"});
};

}  // namespace odeum::methods
