// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// Gives the system of a foreign problem, of which all else is there, its switches and its events,
/// if any: its modes are the system itself between two of them. Functions are called in an isolated
/// process alone. `given` has to outlive it.
void add_happenings(const foreign::ProblemCallbacks& given, System& system);
/// The time at which a usual run of the problem first has an event at the end of a step, so that
/// its solution depends on the steps; infinite: it has none. In an isolated process.
double first_event_of_step(const foreign::ProblemCallbacks& given, const OdeView& view);

}  // namespace odeum::truth
