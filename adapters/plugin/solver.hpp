// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/plugin.h"
#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::plugin {

/// What is wrong with the description, in a sentence; empty where nothing is.
std::string fault_of(const odeum_solver& solver);

/// The solver as an entrant; each solve is made in a process of its own.
Entrant entrant_of(const odeum_solver& solver, const std::string& library,
                   const ErasedContest& contest);

}  // namespace odeum::adapters::plugin
