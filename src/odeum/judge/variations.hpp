// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/core/tolerance.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::judge {

/// The state at `to` from y at `start`, n numbers, and after it the fundamental matrix over that
/// time, row-major, by the variational equations Phi' = J Phi and an own method of order 8. They
/// are linear, so that the matrix has the digits of the tolerance, where differences of runs have
/// half of them. `units`: sizes of the components, in which errors of Phi are measured. Nothing
/// where the case has no Jacobian or the run ends early; wrong where f jumps with the state.
std::vector<double> with_variations(const Case& c, double start, const std::vector<double>& y,
                                    double to, const Tolerance& tolerance,
                                    const std::vector<double>& units);

}  // namespace odeum::judge
