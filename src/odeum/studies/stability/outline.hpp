// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {

using Loop = std::vector<std::pair<double, double>>;

/// The outline of a region's part without growth as closed loops in its plane, by marching squares
/// with linear interpolation between the points of the grid; along the edges of the plane where the
/// part reaches them. A point is inside where an odd number of loops are around it. Empty where
/// there is no growth to outline.
std::vector<Loop> outline(const StabilityRegion& region);

/// The outlines of all regions for the page's scripts.
std::string outlines_json(const std::vector<StabilityRegion>& regions);

}  // namespace odeum::study
