// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/rooted_trees.hpp"

namespace odeum {

std::string bracket_notation(std::size_t tree) {
  if (tree == 0) return "τ";
  std::string inside;
  for (std::size_t t = tree; t != 0; t = all_rooted_trees.left[t])
    inside.insert(0, bracket_notation(all_rooted_trees.right[t]) + (inside.empty() ? "" : ","));
  return "[" + inside + "]";
}

}  // namespace odeum
