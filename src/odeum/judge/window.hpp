// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "odeum/judge/order_fit.hpp"

/// Local slopes of log error against log step, and the window in which they agree.
namespace odeum::judge {

inline constexpr std::size_t fewest_points = 4;  ///< of a window

/// A power law C h^p through points, by least squares in the logarithms.
struct PowerLaw {
  double order = 0;       ///< p
  double half_width = 0;  ///< of the 95 % interval of p
  double log_factor = 0;  ///< log C
  double at(double step) const { return std::exp(log_factor + order * std::log(step)); }
};
PowerLaw fit_power_law(const ErrorPoint* points, std::size_t n);

double local_slope(const ErrorPoint& coarse, const ErrorPoint& fine);

/// A window of neighbouring points; `count` 0: none.
struct Window {
  std::size_t first = 0, count = 0;
  std::size_t end() const { return first + count; }
};

/// The finest window among points [0, end): four points or more, over steps 1.35 apart at least,
/// whose local slopes are positive and differ by `settled` at most from their mean (by half the
/// claimed order's worth of it more among the finest four: high orders settle later), extended by
/// coarser points as long as their slopes agree too.
Window find_window(const std::vector<ErrorPoint>& points, std::size_t end, double claimed_order,
                   double settled);

/// Whether the local slopes of a window, and the one before it, approach an order from each to the
/// next, and the last two so fast that, going on, they are `near` to it at steps ten times finer.
bool moves_towards(const std::vector<ErrorPoint>& points, const Window& window, double order,
                   double near);

}  // namespace odeum::judge
