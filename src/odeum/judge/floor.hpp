// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/judge/order_fit.hpp"

namespace odeum::judge {

/// The level at which an error stops falling, clear of rounding.
struct ErrorFloor {
  std::size_t first = 0;  ///< of the points that do not fall, up to the finest clear one
  double level = 0;       ///< median of their errors
  double step = 0;        ///< the coarsest of their steps
  std::string scale;      ///< what the level scales with, in a few words
};

/// The floor of points [0, end): the longest run of three points or more at the fine end whose
/// errors fall with less than a quarter of an order, though the claimed one would have them fall by
/// the square of `stray`, or four points that settle there. None where errors are of the size of
/// the solution. `first` is `end` where there is none.
ErrorFloor find_floor(const std::vector<ErrorPoint>& points, std::size_t end, double claimed_order,
                      double stray);

}  // namespace odeum::judge
