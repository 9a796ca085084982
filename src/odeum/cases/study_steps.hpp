// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// The smallest number of equal steps, up to 1000, that has every stop on a step; 0: more.
std::uint64_t steps_multiple(double t0, const std::vector<double>& stops);

/// Sets the steps with which studies run a case that has its entrants, by trial runs against its
/// truth, and tags it `stiff` or, where its right-hand side is, `smooth`. Without a known truth
/// only the multiple.
void choose_steps(Case& c, bool smooth, bool known);

}  // namespace odeum::cases
