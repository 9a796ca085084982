// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/cases/conditions.hpp"
#include "odeum/cli/problems.hpp"

namespace odeum::cli {

/// Of the text that a command names, a file or a built-in one; none where it is no text.
cases::Conditions conditions_of(const std::string& what, const ProblemOptions& options,
                                const Case& c);

}  // namespace odeum::cli
