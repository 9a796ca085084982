// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/studies/stability/growth_meter.hpp"
#include "odeum/studies/stability/raster_lanes.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {

/// Both fill the growth, status and detail of a region whose frame, columns and rows are set.
/// Throw Interrupted.

/// Point by point; `mirrored`: solves the rows of the upper half and copies them to the lower one.
void map_region(GrowthMeter& meter, bool mirrored, StabilityRegion& region);

/// An own explicit Runge-Kutta method on the lambda plane, the points of a row together; mirrored.
void map_region_in_lanes(LaneRunner runner, StabilityRegion& region);

}  // namespace odeum::study
