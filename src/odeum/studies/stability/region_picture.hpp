// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {

/// Whether there is a whole grid of growths, with a result in it.
bool can_be_drawn(const StabilityRegion& region);

/// The growths of a region as a PNG of its plane alone, without axes: where there is no growth,
/// four shades by damping; the boundary; growth by 1.25 and by 2 as thin lines; no result. What
/// lies outside is transparent.
std::string region_png(const StabilityRegion& region);

/// Width over height of a picture of the plane.
double aspect_of(const StabilityRegion& region);

}  // namespace odeum::study
