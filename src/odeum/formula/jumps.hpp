// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/formula/graph.hpp"

namespace odeum::formula {

/// The function at whose zeros an expression was found to jump, in extended precision at states
/// near y and times from t to `end`; no_node: none was found. Kinks do not count.
Id jump_of(Graph& graph, Id expression, long double t, long double end,
           const std::vector<long double>& y);

}  // namespace odeum::formula
