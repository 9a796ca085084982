// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

/// Bullet 3.24, double precision: a physics engine, which is given the scene of a case (bodies and
/// forces) and not its right-hand side. Fixed step only.
namespace odeum::adapters::bullet {

void add_solvers(std::vector<Solver>& all);

}  // namespace odeum::adapters::bullet
