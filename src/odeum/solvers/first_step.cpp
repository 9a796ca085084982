// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/first_step.hpp"

#include "odeum/control/adaptive.hpp"

namespace odeum {

double first_step(GuardedView& problem, double t0, const std::vector<double>& y0, double horizon,
                  int order, const Tolerance& tolerance) {
  return initial_step(problem, t0, y0, horizon, order, tolerance);
}

}  // namespace odeum
