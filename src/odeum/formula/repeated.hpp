// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "odeum/formula/graph.hpp"

namespace odeum::formula {

/// Roots of one form: the same operations on other states and other constants. They are computed by
/// one loop, however many they are.
struct Repeated {
  /// An operation on earlier lines, or a leaf: a constant or a state, whose values stand in
  /// `constants` and `states` (of[0] is the number there), the time, or a node `id` from outside.
  struct Line {
    Op op = Op::constant;
    Id id = no_node;  ///< of a node that is computed before the loop
    std::array<std::uint32_t, 3> of{no_node, no_node, no_node};
  };
  std::vector<Line> lines;                          ///< the last one is the root
  std::vector<std::uint32_t> members;               ///< numbers of the roots
  std::vector<std::vector<std::uint32_t>> states;   ///< by leaf, one for each member
  std::vector<std::vector<long double>> constants;  ///< likewise
};

inline constexpr std::uint32_t first_shared = 1U << 31;

struct RepeatedRoots {
  std::vector<Repeated> groups;
  std::vector<std::uint32_t> others;  ///< numbers of the roots in no group
  std::vector<Id> before;             ///< nodes that the groups need from outside
};

/// The forms that at least `least` roots have. A node on which many roots depend belongs to
/// `before`, so that it is computed once. The costly functions that a few roots share, `shared`,
/// count as states: number `first_shared` and following. States up to `split` and from there on are
/// kept apart, since they are arguments of different names.
RepeatedRoots find_repeated(const Graph& graph, const std::vector<Id>& roots, std::size_t least,
                            std::uint32_t split, const std::vector<Id>& shared = {});

/// The functions other than sums, differences, products and quotients that more than one root
/// needs, but not so many that they are in `before`.
std::vector<Id> shared_functions(const Graph& graph, const std::vector<Id>& roots);

}  // namespace odeum::formula
