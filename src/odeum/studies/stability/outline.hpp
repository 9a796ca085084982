// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {

using Loop = std::vector<std::pair<double, double>>;

/// The outline of the part of a region's plane where the growth of a step is at most `level`, as
/// closed loops, by marching squares with linear interpolation between the points of the grid;
/// along the edges of the plane where the part reaches them. A point is inside where an odd number
/// of loops are around it. Empty where no growth is known.
std::vector<Loop> outline(const StabilityRegion& region, double level);

/// The outlines of all regions for the page: of the part without growth (`loops`), and of growths
/// by other factors.
std::string outlines_json(const std::vector<StabilityRegion>& regions, unsigned jobs = 1);

}  // namespace odeum::study
