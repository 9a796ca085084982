// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::odeint {

/// A stepper's properties as documented by odeint. Throws std::logic_error for an unknown name.
SolverInfo info_of(std::string_view method);

/// The steppers on uBLAS matrices: they are compiled once, behind function pointers.
void add_implicit(std::vector<Solver>& all);

}  // namespace odeum::adapters::odeint
