// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/solvers/case.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::cases {

/// Where the computation of a truth was cut short, adds to `end` how long it would take to the last
/// stop: its seconds, times how many more steps an own method takes to there.
/// Nothing where that run fails or takes more than a fifth of these seconds.
void foresee_cost(const Case& c, truth::Reference& reference);

}  // namespace odeum::cases
