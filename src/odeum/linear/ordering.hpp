// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "odeum/problem/sparsity.hpp"

namespace odeum::linear {

/// The reverse Cuthill-McKee ordering of the pattern and its transpose, from a node of nearly
/// largest distance to others in each component (George and Liu, Computer Solution of Large Sparse
/// Positive Definite Systems, 4.3): order[k] is the unknown that comes as number k. The band of a
/// matrix in this order is narrow where its graph is long and thin.
std::vector<int> reverse_cuthill_mckee(const Sparsity& pattern);

/// The band's widths below and above the diagonal when unknown i has the number number[i].
std::pair<std::size_t, std::size_t> bandwidths(const Sparsity& pattern,
                                               const std::vector<int>& number);

}  // namespace odeum::linear
