// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/order_check.hpp"

#include <cmath>
#include <limits>

#include "odeum/core/numbers.hpp"
#include "odeum/solvers/settings.hpp"

namespace odeum::proof {
namespace {

/// Settings of the measurement. High orders reach rounding within a few steps: they get a longer
/// run, and closer step counts.
struct Plan {
  double horizon, ratio, start;
  int count;
  std::uint64_t stops;  ///< where errors are measured; step counts are multiples of it
};
Plan plan_for(double order) {
  if (order <= 2) return {1, 2, 16, 9, 4};
  if (order <= 4) return {1, std::sqrt(2.0), 16, 14, 4};
  if (order <= 6) return {1, std::cbrt(2.0), 8, 17, 4};
  return {2, std::pow(2.0, 1. / 6), 8, 24, 2};
}

// So many errors near rounding show what it comes to.
constexpr int rounding_seen = 4;

}  // namespace

judge::OrderFit measure_order(AnyStepper& stepper, double claimed_order, double t0, double horizon,
                              const std::vector<double>& y0,
                              const std::function<void(double t, double* y)>& truth,
                              double rounding) {
  const Plan plan = plan_for(claimed_order);
  horizon *= plan.horizon;
  std::vector<judge::ErrorPoint> points;
  std::vector<double> exact(y0.size());
  int at_rounding = 0;
  for (const std::uint64_t steps : step_ladder(plan.start, plan.ratio, plan.count, plan.stops)) {
    const double n = static_cast<double>(steps), h = horizon / n;
    judge::ErrorPoint point{.step = h, .error = 0, .steps = n};
    std::vector<double> y = y0;
    stepper.start(t0, h, y);
    for (std::uint64_t i = 0; i < steps; ++i) {
      if (stepper.step(t0 + static_cast<double>(i) * h, h, y) != Status::ok) {
        point.error = nan;
        break;
      }
      if ((i + 1) % (steps / plan.stops) != 0) continue;
      truth(t0 + static_cast<double>(i + 1) * h, exact.data());
      for (std::size_t k = 0; k < y.size(); ++k) {
        const double error = std::abs(y[k] - exact[k]);
        // NaN stays as the largest error
        if (!(error <= point.error)) point.error = error;
        point.scale = std::max(point.scale, std::abs(exact[k]));
      }
    }
    point.rounding_unit = rounding * point.scale * std::numeric_limits<double>::epsilon() / 2;
    points.push_back(point);
    at_rounding = point.error <= point.typical_rounding() ? at_rounding + 1 : 0;
    if (at_rounding >= rounding_seen && points.size() >= 6) break;
  }
  return judge::fit_order(points, claimed_order, judge::fixed_step_tolerance(claimed_order));
}

}  // namespace odeum::proof
