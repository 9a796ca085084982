// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/plugin.h"
#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::plugin {

/// What is wrong with the description, in a sentence; empty where nothing is.
std::string fault_of(const odeum_solver& solver);

/// The solver, which has to outlive it; each solve is made in a process of its own.
Solver solver_of(const odeum_solver& solver, const std::string& library);

}  // namespace odeum::adapters::plugin
