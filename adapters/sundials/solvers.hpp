// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::sundials {

/// Every solver of CVODE and ARKODE, which fit any problem: the implicit ones use difference
/// quotients where it offers no Jacobian. And IDA, which needs an implicit form.
void add_solvers(std::vector<Solver>& all);

}  // namespace odeum::adapters::sundials
