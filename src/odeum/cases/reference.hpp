// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// The text of cases/reference/<name>.csv; throws std::runtime_error where there is none.
std::string_view reference_text(const std::string& name);

/// The truth held in cases/reference/<name>.csv (built into the program), known at its tabulated
/// times only. `floor` is its absolute error as stated by its index: from its digits, or from
/// inputs rounded to double. Throws std::runtime_error where the file is missing or malformed.
/// With a `folder`, the file <name> or <name>.csv in it is taken where there is one.
Truth reference_truth(const std::string& name, double floor, const std::string& folder = {});

/// The same file rounded to extended precision, see ExtendedProblem::truth.
std::function<bool(double t, long double* y)> extended_truth(const std::string& name);

}  // namespace odeum::cases
