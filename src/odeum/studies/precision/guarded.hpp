// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/studies/precision/timing.hpp"

/// The runs that count evaluations and measure errors, before solvers are timed.
namespace odeum::study {

/// Runs a solver at the settings of its mode, from coarse to fine, each for `seconds` at most, as
/// far as the budget goes.
void run_guarded(const TimedCase& stage, TimedSolver& solver, double seconds);

/// A library none of whose solvers solves a case within the budget may have one that does beyond:
/// its solvers that ended over budget run once more, to the loosest tolerance, with thirty times
/// the evaluations that the case allows.
void run_beyond_budget(const TimedCase& stage, std::vector<TimedSolver>& solvers,
                       const Runner& runner, double seconds);

}  // namespace odeum::study
