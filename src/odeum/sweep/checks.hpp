// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/sweep/sweep.hpp"

namespace odeum::sweep {

/// Holds some members, evenly spread, against a truth of their own each.
void check_members(const Plan& plan, Result& result);

/// The quantiles of every component at the plan's stops, over at most 500 members.
void add_over_time(const Plan& plan, Result& result);

}  // namespace odeum::sweep
