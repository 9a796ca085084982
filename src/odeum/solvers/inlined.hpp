// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum {

/// For timed runs: the solvers of a case that are also compiled with its right-hand side inlined
/// (cases/inlined), by SolverInfo::id(). They neither guard nor count: give them only requests that
/// a guarded run has completed. Empty for most cases.
std::vector<Entrant> inlined_solvers(const Case& c);

}  // namespace odeum
