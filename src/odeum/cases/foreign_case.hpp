// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/text_case.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/solvers/foreign_problem.hpp"

namespace odeum::cases {

/// The case of a problem of a plug-in or an FMU, with every solver enrolled; each solve is made in
/// a process of its own. Its truth is its exact solution, else a reference
/// (truth/foreign_reference.hpp, kept in the cache folder), else unknown.
TextCase foreign_case(foreign::ProblemCallbacks from);

}  // namespace odeum::cases
