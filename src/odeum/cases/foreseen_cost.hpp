// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/solvers/case.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::cases {

/// Where the computation of a truth was cut short, adds to `end` how long it would take to the last
/// stop. Explicit methods come that far on stiff problems by steps of one length, so that their
/// seconds are those of the time that is left; of implicit ones, by the steps that an own method
/// takes, where that comes to the end within a fifth of the seconds.
void foresee_cost(const Case& c, truth::Reference& reference);

}  // namespace odeum::cases
