// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace odeum {

/// Conditions are checked up to this order at run time (1205 trees).
inline constexpr int highest_order_checked = 10;

/// A rooted tree as an earlier tree, `left`, on whose root another, `right`, is grafted. The single
/// node, number 0, has neither.
struct RootedTree {
  int nodes = 1;
  std::size_t left = 0, right = 0;
  unsigned long density = 1;  ///< gamma(tau): the product of the sizes of all its subtrees
};

/// Every rooted tree with at most `highest_order_checked` nodes, by number of nodes, each once.
const std::vector<RootedTree>& all_rooted_trees();

/// A tree in brackets (Hairer, Norsett, Wanner, Solving ODEs I, definition II.2.12): τ is the
/// single node and [τ,[τ]] a root that carries a node and a chain of two.
std::string bracket_notation(std::size_t tree);

}  // namespace odeum
