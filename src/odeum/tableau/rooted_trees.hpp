// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <string>

namespace odeum {

/// The rooted trees with at most `MaxOrder` nodes, each as the root joined to an earlier subtree:
/// tree = butcher_product(left, right) grafts `right` onto the root of `left`. Every tree but the
/// single node has such a form; keeping `right` no later than the last one grafted onto `left`
/// lists each tree once.
template <int MaxOrder>
struct RootedTrees {
  static constexpr std::array<std::size_t, 11> count_to{0, 1, 2, 4, 8, 17, 37, 85, 200, 486, 1205};
  static_assert(MaxOrder >= 1 && MaxOrder <= 10);
  static constexpr std::size_t count = count_to[MaxOrder];

  std::array<int, count> nodes{};
  std::array<std::size_t, count> left{}, right{};
  std::array<double, count> density{};  ///< gamma(tau)

  consteval RootedTrees() {
    nodes[0] = 1;
    density[0] = 1;
    // gamma(tau) = nodes(tau) * product of the densities of the root's subtrees.
    std::array<double, count> children_density{};
    children_density[0] = 1;
    std::size_t made = 1;
    for (int n = 2; n <= MaxOrder; ++n) {
      for (std::size_t l = 0; l < count_to[static_cast<std::size_t>(n) - 1]; ++l) {
        // Grafts in non-increasing order: each tree once.
        const auto size = static_cast<std::size_t>(n - nodes[l]);
        const std::size_t last = l == 0 ? made : right[l] + 1;
        for (std::size_t r = count_to[size - 1]; r < count_to[size] && r < last; ++r) {
          nodes[made] = n;
          left[made] = l;
          right[made] = r;
          children_density[made] = children_density[l] * density[r];
          density[made] = n * children_density[made];
          ++made;
        }
      }
    }
    if (made != count) throw "rooted trees miscounted";
  }
};

template <int MaxOrder>
inline constexpr RootedTrees<MaxOrder> rooted_trees{};

/// Conditions are checked up to this order at run time (1205 trees).
inline constexpr int highest_order_checked = 10;
inline constexpr const auto& all_rooted_trees = rooted_trees<highest_order_checked>;

/// A tree in brackets (Hairer, Norsett, Wanner, Solving ODEs I, definition II.2.12): τ is the
/// single node and [τ,[τ]] a root that carries a node and a chain of two.
std::string bracket_notation(std::size_t tree);

}  // namespace odeum
