// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/order_check.hpp"

#include <cmath>
#include <limits>

namespace odeum::proof {
namespace {

constexpr std::uint64_t stops = 4;

/// Step counts from coarse to fine, multiples of the number of stops: close together where the
/// order is high, since few of them lie between the first that converge and rounding.
std::vector<std::uint64_t> ladder(double order) {
  const double ratio = order <= 2 ? 2 : order <= 4 ? std::sqrt(2.0) : std::cbrt(2.0);
  const int count = order <= 2 ? 9 : order <= 4 ? 14 : 17;
  const double start = order <= 4 ? 16 : 8;
  std::vector<std::uint64_t> steps;
  for (int k = 0; k < count; ++k) {
    const auto units = std::llround(start * std::pow(ratio, k) / stops);
    const std::uint64_t n = static_cast<std::uint64_t>(std::max(units, 1LL)) * stops;
    if (steps.empty() || n > steps.back()) steps.push_back(n);
  }
  return steps;
}

}  // namespace

study::OrderFit measure_order(AnyStepper& stepper, double claimed_order, double t0, double horizon,
                              const std::vector<double>& y0,
                              const std::function<void(double t, double* y)>& truth) {
  std::vector<study::ErrorPoint> points;
  std::vector<double> exact(y0.size());
  int at_rounding = 0;
  for (const std::uint64_t steps : ladder(claimed_order)) {
    const double n = static_cast<double>(steps), h = horizon / n;
    study::ErrorPoint point{.step = h, .error = 0, .steps = n};
    std::vector<double> y = y0;
    stepper.start(t0, h, y);
    for (std::uint64_t i = 0; i < steps; ++i) {
      if (stepper.step(t0 + static_cast<double>(i) * h, h, y) != Status::ok) {
        point.error = std::numeric_limits<double>::quiet_NaN();
        break;
      }
      if ((i + 1) % (steps / stops) != 0) continue;
      truth(t0 + static_cast<double>(i + 1) * h, exact.data());
      for (std::size_t k = 0; k < y.size(); ++k) {
        const double error = std::abs(y[k] - exact[k]);
        // NaN stays, as the largest error there is
        if (!(error <= point.error)) point.error = error;
        point.rounding_unit = std::max(
            point.rounding_unit, std::abs(exact[k]) * std::numeric_limits<double>::epsilon() / 2);
      }
    }
    points.push_back(point);
    at_rounding = point.error <= point.typical_rounding() ? at_rounding + 1 : 0;
    if (at_rounding >= 2 && points.size() >= 6) break;
  }
  return study::fit_order(points, claimed_order, study::fixed_step_tolerance(claimed_order));
}

}  // namespace odeum::proof
