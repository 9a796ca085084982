// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/contest/case.hpp"

namespace odeum::cases {

/// The cases of libraries that are known only at run time (contest/late.hpp), with every solver
/// enrolled.
std::vector<Case> late_cases();

}  // namespace odeum::cases
