// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/half_edges.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <numeric>

namespace odeum::fem {
namespace {

/// Counts and stores the edges of each node in the order of the triangles; false for wrong ids.
bool store_edges(const TriangleMesh& mesh, HalfEdges& edges) {
  const std::size_t n = mesh.nodes.size();
  edges.start.assign(n + 1, 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    if (a >= n || b >= n || c >= n || a == b || b == c || c == a) return false;
    ++edges.start[a], ++edges.start[b], ++edges.start[c];
  }
  std::partial_sum(edges.start.begin(), edges.start.end(), edges.start.begin());
  edges.to.resize(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    edges.to[static_cast<std::size_t>(--edges.start[a])] = static_cast<int>(b);
    edges.to[static_cast<std::size_t>(--edges.start[b])] = static_cast<int>(c);
    edges.to[static_cast<std::size_t>(--edges.start[c])] = static_cast<int>(a);
  }
  return true;
}

/// Sorts the edges of a node, of which it has few; false where it has none, or one twice.
bool sort_edges(int* begin, const int* end) {
  if (begin == end) return false;
  for (int* next = begin + 1; next < end; ++next) {
    const int value = *next;
    int* place = next;
    for (; place > begin && place[-1] > value; --place) *place = place[-1];
    if (place > begin && place[-1] == value) return false;
    *place = value;
  }
  return true;
}

bool in_one_piece(const HalfEdges& edges) {
  const auto n = static_cast<int>(edges.start.size()) - 1;
  std::vector<int> group(static_cast<std::size_t>(n));
  // A node joins its lowest neighbour: few remain that have none below them, and mostly one.
  int groups = 0;
  for (int i = 0; i < n; ++i) group[i] = std::min(i, edges.to[edges.start[i]]);
  for (const auto& [from, to] : edges.boundary) group[to] = std::min(group[to], from);
  for (int i = 0; i < n; ++i) groups += group[i] == i;
  if (groups == 1) return true;
  const auto root = [&](int i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (int i = 0; i < n; ++i)
    for (int k = edges.start[i]; k < edges.start[i + 1]; ++k) {
      const int a = root(i), b = root(edges.to[k]);
      if (a == b) continue;
      group[std::max(a, b)] = std::min(a, b);
      if (--groups == 1) return true;
    }
  return false;
}

}  // namespace

std::optional<HalfEdges> half_edges(const TriangleMesh& mesh, Team& team) {
  if (mesh.triangles.empty()) return std::nullopt;
  if (std::max(3 * mesh.triangles.size(), mesh.nodes.size()) >
      static_cast<std::size_t>(std::numeric_limits<int>::max()) / 2)
    throw MeshError("the mesh has more triangles than the matrix can number");
  HalfEdges edges;
  if (!store_edges(mesh, edges)) return std::nullopt;
  const auto end_of = [&](int node) { return edges.to.data() + edges.start[node + 1]; };
  const auto begin_of = [&](int node) { return edges.to.data() + edges.start[node]; };
  std::atomic<bool> sound = true;
  team.run(mesh.nodes.size(), [&](std::size_t first, std::size_t end) {
    for (auto i = static_cast<int>(first); i < static_cast<int>(end); ++i)
      if (!sort_edges(begin_of(i), end_of(i))) sound = false;
  });
  if (!sound) return std::nullopt;
  std::mutex joining;
  team.run(mesh.nodes.size(), [&](std::size_t first, std::size_t end) {
    std::vector<std::array<int, 2>> boundary;
    for (auto i = static_cast<int>(first); i < static_cast<int>(end); ++i)
      for (const int* to = begin_of(i); to < end_of(i); ++to)
        if (std::find(begin_of(*to), end_of(*to), i) == end_of(*to)) boundary.push_back({i, *to});
    const std::lock_guard lock(joining);
    edges.boundary.insert(edges.boundary.end(), boundary.begin(), boundary.end());
  });
  std::ranges::sort(edges.boundary);
  if (!in_one_piece(edges)) return std::nullopt;
  return edges;
}

}  // namespace odeum::fem
