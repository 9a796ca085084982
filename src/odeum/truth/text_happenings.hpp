// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/formula/problem.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// A constant that rounding could have moved, moved by `moved_by` of itself.
Real moved(Real c);

/// Gives a system the events of a text, if any.
void add_happenings(const formula::Problem& problem, System& system);

}  // namespace odeum::truth
