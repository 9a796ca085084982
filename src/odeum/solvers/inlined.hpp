// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum {

/// For timed runs: the solvers of a case that are also compiled with its right-hand side inlined
/// (cases/inlined), by SolverInfo::id(). They watch and count nothing, so that only a request which
/// a watched run has answered may be put to them. Empty for most cases.
std::vector<Entrant> inlined_solvers(const Case& c);

}  // namespace odeum
