// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::sundials {

/// Every solver of CVODE and ARKODE. All of them fit any problem: the implicit ones use difference
/// quotients where it offers no Jacobian.
void add_solvers(std::vector<Solver>& all);

}  // namespace odeum::adapters::sundials
