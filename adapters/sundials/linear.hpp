// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/linear/linear_peer.hpp"

namespace odeum::adapters::sundials {

/// Adds the library's solvers of sparse symmetric systems.
void add_linear_peers(std::vector<linear::LinearPeerInfo>& peers);

}  // namespace odeum::adapters::sundials
