// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <functional>
#include <vector>

#include "odeum/judge/order_fit.hpp"

namespace odeum::judge {

inline constexpr double half_epsilon = 0x1p-53;  // the solution is of size one

/// Errors over a horizon of 10, at steps from 0.5 on.
inline std::vector<ErrorPoint> ladder(double ratio, int count,
                                      const std::function<double(double h)>& error) {
  std::vector<ErrorPoint> points;
  for (int k = 0; k < count; ++k) {
    const double h = 0.5 * std::pow(ratio, -k);
    points.push_back(
        {.step = h, .error = error(h), .steps = 10 / h, .rounding_unit = half_epsilon, .scale = 1});
  }
  return points;
}

inline OrderFit fit_fixed(const std::vector<ErrorPoint>& points, double claimed) {
  return fit_order(points, claimed, fixed_step_tolerance(claimed));
}

}  // namespace odeum::judge
