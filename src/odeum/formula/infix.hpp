// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/formula/graph.hpp"

namespace odeum::formula {

/// An expression for people, in the notation of problem files; empty where it is longer than
/// `most` characters. `states`: their names.
std::string infix_of(const Graph& graph, Id id, const std::vector<std::string>& states,
                     std::size_t most = 120);

}  // namespace odeum::formula
