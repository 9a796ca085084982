// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <vector>

#include "odeum/core/guarded.hpp"

namespace odeum {

/// The first step for a library that asks its user for one: the rule that own methods follow
/// (initial_step in control/adaptive.hpp), for two guarded evaluations. `order` is that of the
/// method's first step.
double first_step(GuardedView& problem, double t0, const std::vector<double>& y0, double horizon,
                  int order, const Tolerance& tolerance);

}  // namespace odeum
