// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum {

/// A solver for each file of methods/, by id. CMake generates a unit for each of them (see
/// odeum_generate_methods), in which it is compiled for the shared types: a method that is added or
/// changed is compiled there and nowhere else.
const std::vector<Solver>& own_methods();

/// The one of that name; null: there is none.
const Solver* find_own_solver(std::string_view method);
/// The one of that name, which there has to be.
const Solver& own_solver(std::string_view method);

}  // namespace odeum
