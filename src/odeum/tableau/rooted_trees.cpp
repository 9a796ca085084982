// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/rooted_trees.hpp"

namespace odeum {

const std::vector<RootedTree>& all_rooted_trees() {
  static const std::vector<RootedTree> all = [] {
    std::vector<RootedTree> trees(1);
    std::vector<unsigned long> subtrees_density{1};  // of the root's subtrees together
    for (int n = 2; n <= highest_order_checked; ++n) {
      const std::size_t smaller = trees.size();
      for (std::size_t l = 0; l < smaller; ++l)
        for (std::size_t r = 0; r < smaller; ++r) {
          if (trees[l].nodes + trees[r].nodes != n) continue;
          if (l != 0 && r > trees[l].right) continue;  // grafted in falling order: each tree once
          const unsigned long below = subtrees_density[l] * trees[r].density;
          trees.push_back({n, l, r, static_cast<unsigned long>(n) * below});
          subtrees_density.push_back(below);
        }
    }
    return trees;
  }();
  return all;
}

std::string bracket_notation(std::size_t tree) {
  const std::vector<RootedTree>& trees = all_rooted_trees();
  if (tree == 0) return "τ";
  std::string inside;
  for (std::size_t t = tree; t != 0; t = trees[t].left)
    inside = bracket_notation(trees[t].right) + (inside.empty() ? "" : "," + inside);
  return "[" + inside + "]";
}

}  // namespace odeum
