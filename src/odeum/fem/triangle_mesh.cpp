// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace odeum::fem {
namespace {

/// An edge of a triangle with its nodes in rising order; `forward`: the triangle has them so too.
struct Edge {
  std::size_t low, high, triangle;
  bool forward;
};

/// Every triangle's edges, sorted so that those between the same nodes follow one another: first
/// into the places of their lower nodes, of which each has few.
std::vector<Edge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<std::size_t> place(mesh.nodes.size() + 1);
  const auto for_all = [&](const auto& use) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        use(t, mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
  };
  for_all([&](std::size_t, std::size_t a, std::size_t b) { ++place[std::min(a, b) + 1]; });
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<Edge> edges(3 * mesh.triangles.size());
  for_all([&](std::size_t t, std::size_t a, std::size_t b) {
    edges[place[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), t, a < b};
  });
  // Each place is now the end of its node's edges.
  std::size_t begin = 0;
  for (std::size_t node = 0; node < mesh.nodes.size(); begin = place[node++])
    std::sort(edges.begin() + static_cast<long>(begin),
              edges.begin() + static_cast<long>(place[node]), [](const Edge& l, const Edge& r) {
                return std::tie(l.high, l.triangle) < std::tie(r.high, r.triangle);
              });
  return edges;
}

/// Calls work(first, end) for the edges between each pair of nodes.
template <class Work>
void for_each_edge(const std::vector<Edge>& edges, Work&& work) {
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    while (end < edges.size() && edges[end].low == edges[first].low &&
           edges[end].high == edges[first].high)
      ++end;
    work(first, end);
  }
}

/// The checks of one mesh.
class Check {
 public:
  Check(const TriangleMesh& mesh, const MeshTags& tags) : mesh_(mesh), tags_(tags) {}

  void nodes() const {
    if (mesh_.triangles.empty()) throw MeshError("the mesh has no triangles");
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i)
      if (!std::isfinite(mesh_.nodes[i].x) || !std::isfinite(mesh_.nodes[i].y))
        refuse_node(i, "is not at a finite point");
  }

  void triangle(std::size_t t) const {
    const auto& ids = mesh_.triangles[t];
    for (const std::size_t id : ids)
      if (id >= mesh_.nodes.size())
        refuse(t, "has node " + std::to_string(id) + ", but there are only " +
                      std::to_string(mesh_.nodes.size()) + " nodes, from 0");
    if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0]) refuse(t, "has a node twice");
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, distance(mesh_.nodes[ids[k]], mesh_.nodes[ids[(k + 1) % 3]]));
    const double doubled = doubled_area(mesh_, t);
    if (!(std::abs(doubled) > degenerate_area * longest * longest))
      refuse(t, "is degenerate: its nodes lie on a line");
    if (doubled < 0) refuse(t, "is inverted: its nodes run clockwise");
  }

  void duplicates() const {
    std::vector<std::pair<std::array<std::size_t, 3>, std::size_t>> sorted;
    sorted.reserve(mesh_.triangles.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      sorted.emplace_back(mesh_.triangles[t], t);
      std::ranges::sort(sorted.back().first);
    }
    std::ranges::sort(sorted);
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i].first == sorted[i - 1].first)
        refuse(sorted[i].second, "is a duplicate of " + triangle_name(sorted[i - 1].second));
  }

  void edges() const {
    const std::vector<Edge> edges = sorted_edges(mesh_);
    for_each_edge(edges, [&](std::size_t first, std::size_t end) {
      const Edge& e = edges[first];
      const auto between = [&] {
        return "the edge between " + node_name(e.low) + " and " + node_name(e.high);
      };
      if (end - first > 2) refuse(e.triangle, "and two more have " + between());
      // Both counterclockwise on the same side of it.
      if (end - first == 2 && e.forward == edges[first + 1].forward)
        refuse(edges[first + 1].triangle,
               "overlaps " + triangle_name(e.triangle) + " at " + between());
    });
  }

  void pieces() const {
    std::vector<std::size_t> group(mesh_.nodes.size());
    std::iota(group.begin(), group.end(), 0);
    const auto root = [&](std::size_t i) {
      while (group[i] != i) i = group[i] = group[group[i]];
      return i;
    };
    std::vector<bool> used(mesh_.nodes.size());
    for (const auto& ids : mesh_.triangles)
      for (const std::size_t id : ids) {
        used[id] = true;
        group[root(id)] = root(ids[0]);
      }
    for (std::size_t i = 0; i < used.size(); ++i)
      if (!used[i]) refuse_node(i, "belongs to no triangle");
    for (std::size_t t = 1; t < mesh_.triangles.size(); ++t)
      if (root(mesh_.triangles[t][0]) != root(mesh_.triangles[0][0]))
        throw MeshError("the mesh is in more than one piece: " + triangle_name(t) +
                            " is not connected to " + triangle_name(0),
                        MeshError::Of::triangle, t);
  }

 private:
  static std::string name(const char* what, const std::vector<std::size_t>& tags, std::size_t i) {
    return what + std::to_string(tags.empty() ? i : tags[i]);
  }
  std::string node_name(std::size_t i) const { return name("node ", tags_.nodes, i); }
  std::string triangle_name(std::size_t t) const { return name("triangle ", tags_.triangles, t); }
  [[noreturn]] void refuse(std::size_t t, const std::string& what) const {
    throw MeshError(triangle_name(t) + ' ' + what, MeshError::Of::triangle, t);
  }
  [[noreturn]] void refuse_node(std::size_t i, const std::string& what) const {
    throw MeshError(node_name(i) + ' ' + what, MeshError::Of::node, i);
  }

  const TriangleMesh& mesh_;
  const MeshTags& tags_;
};

}  // namespace

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

double doubled_area(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& ids = mesh.triangles[triangle];
  const Point a = mesh.nodes[ids[0]], b = mesh.nodes[ids[1]], c = mesh.nodes[ids[2]];
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

void check_triangle(const TriangleMesh& mesh, std::size_t triangle) {
  Check(mesh, {}).triangle(triangle);
}

void check(const TriangleMesh& mesh, const MeshTags& tags) {
  const Check that(mesh, tags);
  that.nodes();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) that.triangle(t);
  try {
    that.edges();
  } catch (const MeshError&) {
    // A duplicate has the edges of another triangle: it is told as what it is.
    that.duplicates();
    throw;
  }
  that.pieces();
}

std::vector<std::array<std::size_t, 2>> boundary_edges(const TriangleMesh& mesh) {
  const std::vector<Edge> edges = sorted_edges(mesh);
  std::vector<std::array<std::size_t, 2>> boundary;
  for_each_edge(edges, [&](std::size_t first, std::size_t end) {
    const Edge& e = edges[first];
    if (end - first == 1)
      boundary.push_back(e.forward ? std::array{e.low, e.high} : std::array{e.high, e.low});
  });
  return boundary;
}

double longest_edge(const TriangleMesh& mesh) {
  double longest = 0;
  for (const auto& ids : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, distance(mesh.nodes[ids[k]], mesh.nodes[ids[(k + 1) % 3]]));
  return longest;
}

Refined refined(const TriangleMesh& mesh, const std::function<Point(Point)>& onto_boundary) {
  struct Node {
    Point at;
    std::array<std::size_t, 2> parents;
  };
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) nodes.push_back({mesh.nodes[i], {i, i}});
  const std::vector<Edge> edges = sorted_edges(mesh);
  // middles[t][k]: the middle of the edge of triangle t that is opposite to its node k.
  std::vector<std::array<std::size_t, 3>> middles(mesh.triangles.size());
  for_each_edge(edges, [&](std::size_t first, std::size_t end) {
    const Edge& e = edges[first];
    Point at = middle(mesh.nodes[e.low], mesh.nodes[e.high]);
    if (end - first == 1 && onto_boundary) at = onto_boundary(at);
    for (std::size_t i = first; i < end; ++i) {
      const auto& ids = mesh.triangles[edges[i].triangle];
      for (std::size_t k = 0; k < 3; ++k)
        if (ids[k] != e.low && ids[k] != e.high) middles[edges[i].triangle][k] = nodes.size();
    }
    nodes.push_back({at, {e.low, e.high}});
  });
  std::vector<std::size_t> order(nodes.size()), place(nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return std::tie(nodes[a].at.y, nodes[a].at.x) < std::tie(nodes[b].at.y, nodes[b].at.x);
  });
  Refined fine;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    fine.mesh.nodes.push_back(nodes[order[i]].at);
    fine.parents.push_back(nodes[order[i]].parents);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::size_t, 3> corner{}, m{};
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = place[mesh.triangles[t][k]], m[k] = place[middles[t][k]];
    for (std::size_t k = 0; k < 3; ++k)
      fine.mesh.triangles.push_back({corner[k], m[(k + 2) % 3], m[(k + 1) % 3]});
    fine.mesh.triangles.push_back(m);
  }
  return fine;
}

}  // namespace odeum::fem
