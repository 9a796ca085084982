// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/ordering.hpp"

#include <numeric>

namespace odeum::linear {
namespace {

/// The neighbours of each unknown in the pattern or its transpose, each once, without itself.
std::vector<std::vector<int>> neighbours_of(const Sparsity& pattern) {
  std::vector<std::vector<int>> of(pattern.unknowns());
  for (std::size_t i = 0; i < pattern.unknowns(); ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(pattern.column[k]);
      if (i == j) continue;
      of[i].push_back(static_cast<int>(j));
      of[j].push_back(static_cast<int>(i));
    }
  for (std::vector<int>& list : of) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  for (std::vector<int>& list : of)
    std::stable_sort(list.begin(), list.end(),
                     [&](int a, int b) { return of[a].size() < of[b].size(); });
  return of;
}

struct Levels {
  std::vector<int> order;  ///< breadth first
  int depth = 0;           ///< of the last
};

/// The levels from `start`; `level` is all -1 before and after.
Levels levels_from(int start, const std::vector<std::vector<int>>& neighbours,
                   std::vector<int>& level) {
  Levels found;
  found.order = {start};
  level[start] = 0;
  for (std::size_t at = 0; at < found.order.size(); ++at)
    for (const int next : neighbours[found.order[at]])
      if (level[next] < 0) {
        level[next] = level[found.order[at]] + 1;
        found.order.push_back(next);
      }
  found.depth = level[found.order.back()];
  for (const int node : found.order) level[node] = -1;
  return found;
}

}  // namespace

std::vector<int> reverse_cuthill_mckee(const Sparsity& pattern) {
  const auto neighbours = neighbours_of(pattern);
  std::vector<int> order, level(pattern.unknowns(), -1);
  std::vector<bool> placed(pattern.unknowns(), false);
  order.reserve(pattern.unknowns());
  for (std::size_t first = 0; first < pattern.unknowns(); ++first) {
    if (placed[first]) continue;
    Levels best = levels_from(static_cast<int>(first), neighbours, level);
    while (true) {
      Levels farther = levels_from(best.order.back(), neighbours, level);
      const bool deeper = farther.depth > best.depth;
      best = std::move(farther);
      if (!deeper) break;
    }
    for (const int node : best.order) placed[node] = true;
    order.insert(order.end(), best.order.begin(), best.order.end());
  }
  std::reverse(order.begin(), order.end());
  return order;
}

Band band_of(const Sparsity& pattern, std::vector<int> order) {
  if (order.empty()) {
    order.resize(pattern.unknowns());
    std::iota(order.begin(), order.end(), 0);
  }
  Band band{.order = std::move(order), .number = std::vector<int>(pattern.unknowns())};
  for (std::size_t k = 0; k < band.order.size(); ++k)
    band.number[band.order[k]] = static_cast<int>(k);
  int lower = 0, upper = 0;
  for (std::size_t i = 0; i < pattern.unknowns(); ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
      const int above = band.number[pattern.column[k]] - band.number[i];
      lower = std::max(lower, -above);
      upper = std::max(upper, above);
    }
  band.lower = static_cast<std::size_t>(lower), band.upper = static_cast<std::size_t>(upper);
  return band;
}

}  // namespace odeum::linear
