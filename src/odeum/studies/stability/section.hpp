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

/// Whether there is a whole grid of growths, with a result in it.
bool can_be_drawn(const StabilityRegion& region);

/// The growths of a region as a PNG of its plane alone, without axes: where there is no growth,
/// four shades by damping; the boundary; growth by 1.25 and by 2 as thin lines; no result. What
/// lies outside is transparent.
std::string region_png(const StabilityRegion& region);

/// Width over height of a picture of the plane.
double aspect_of(const StabilityRegion& region);

}  // namespace odeum::study
