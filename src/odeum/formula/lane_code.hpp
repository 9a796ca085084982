// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/core/lane_view.hpp"
#include "odeum/formula/text_ode.hpp"

namespace odeum::formula {

/// The functions of LaneView as C, with the operations of print_c() in the same order, so that the
/// compiler rounds them alike. Choices (if, min, max) have no such form.
std::string print_lanes(const Problem& problem, const Analysis& analysis);

/// The code of a problem whose parameters kept their names, compiled for members in lanes; without
/// `rhs` where there is no compiler, and where it has choices.
LaneView compile_lanes(const TextOde& ode);

}  // namespace odeum::formula
