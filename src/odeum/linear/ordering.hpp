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

/// A numbering of unknowns, and the widths of their band below and above the diagonal.
struct Band {
  std::vector<int> order, number;  ///< inverse to one another: order[k] has the number k
  std::size_t lower = 0, upper = 0;
};
/// An empty `order`: that of the pattern.
Band band_of(const Sparsity& pattern, std::vector<int> order = {});

}  // namespace odeum::linear
