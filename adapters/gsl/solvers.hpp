// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

/// The GNU Scientific Library's solvers of ordinary differential equations, gsl_odeiv2: eleven
/// steppers.
namespace odeum::adapters::gsl {

void add_solvers(std::vector<Solver>& all);

}  // namespace odeum::adapters::gsl
