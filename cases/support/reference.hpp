// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "odeum/contest/case.hpp"

namespace odeum::cases {

/// The truth held in cases/reference/<name>.csv (built into the program), known at its way points
/// only. `floor` is what its index says: from its digits, or from inputs rounded to double.
/// Throws std::runtime_error where the file is missing or malformed.
Truth reference_truth(const std::string& name, double floor);

/// The same file with all of its digits that extended precision holds, see ExtendedProblem::truth.
std::function<bool(double t, long double* y)> extended_truth(const std::string& name);

}  // namespace odeum::cases
