// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::sundials {

/// IDA, on problems with an implicit form.
void add_ida(std::vector<Solver>& all);

}  // namespace odeum::adapters::sundials
