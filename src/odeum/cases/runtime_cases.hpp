// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// The cases of libraries that are known only at run time (solvers/runtime_library.hpp), with every
/// solver enrolled.
std::vector<Case> runtime_cases();

}  // namespace odeum::cases
