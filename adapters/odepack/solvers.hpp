// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::odepack {

/// LSODA, LSODE, VODE and RADAU5, compiled from Fortran, which fit any problem. They are not
/// reentrant: runs of several threads wait for one another.
void add_solvers(std::vector<Solver>& all);

}  // namespace odeum::adapters::odepack
