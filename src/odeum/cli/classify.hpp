// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "odeum/cli/session.hpp"

namespace odeum::cli {

/// Prints A, b, the eigenvalues and the solution of a linear problem u' = A u + b, and with solvers
/// the matrix that one step of each applies. Throws UsageError where the problem is none, or a
/// solver has no such step.
void classify_linear(const Case& c, const std::vector<std::string>& solvers,
                     std::optional<double> step);

}  // namespace odeum::cli
