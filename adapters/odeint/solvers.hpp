// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

/// Boost.Numeric.Odeint: every stepper that it has, compiled in this folder for the shared types;
/// for the type of a problem of its own see odeint/inlined.hpp.
namespace odeum::adapters::odeint {

void add_solvers(std::vector<Solver>& all);

}  // namespace odeum::adapters::odeint
