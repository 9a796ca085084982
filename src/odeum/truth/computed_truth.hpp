// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::truth {

/// The truth of a case at the given times (ascending, after t0): its own where that is known, else
/// a reference computed in extended precision (truth/system.hpp), as far as one is found. `source`
/// says what was computed and up to which time, or why nothing was. Without a right-hand side in
/// extended precision, or with events, it is the case's own.
Truth truth_at(const Case& c, const std::vector<double>& times, const TruthBounds& bounds = {});

/// Gives it to the case, unless its own is known at the last of the times.
void know_truth(Case& c, const std::vector<double>& times, const TruthBounds& bounds = {});

}  // namespace odeum::truth
