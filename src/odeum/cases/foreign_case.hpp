// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/catalogue.hpp"
#include "odeum/solvers/foreign_problem.hpp"

namespace odeum::cases {

/// The case of a problem of a plug-in or an FMU; each solve is made in a process of its own. Its
/// truth is its exact solution, else a reference (truth/foreign_reference.hpp, kept in the cache
/// folder), else unknown.
Statement foreign_statement(foreign::ProblemCallbacks from);

}  // namespace odeum::cases
