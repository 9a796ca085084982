// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace odeum::fem {

struct Point {
  double x = 0, y = 0;
};
inline Point middle(Point a, Point b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
double distance(Point a, Point b);

/// A mesh of triangles in the plane, nodes of each counterclockwise.
struct TriangleMesh {
  std::vector<Point> nodes;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// A mesh that cannot be used, with the number (from 0) of the triangle or node.
class MeshError : public std::runtime_error {
 public:
  enum class Of { mesh, node, triangle };
  explicit MeshError(const std::string& what, Of of = Of::mesh, std::size_t number = 0)
      : std::runtime_error(what), of_(of), number_(number) {}
  Of of() const { return of_; }
  std::size_t number() const { return number_; }

 private:
  Of of_;
  std::size_t number_;
};

/// What a file calls its nodes and triangles; empty: their numbers from 0.
struct MeshTags {
  std::vector<std::size_t> nodes, triangles;
};

/// Throws MeshError for a mesh without triangles, and for the first node or triangle found that is
/// wrong: a node that is not finite, ids out of range or equal, a triangle that is degenerate or
/// inverted, duplicate triangles, an edge of more than two triangles, a node of no triangle, or
/// more than one piece. `tags` are their names in messages.
void check(const TriangleMesh& mesh, const MeshTags& tags = {});

/// Twice the area over the square of the longest edge, below which a triangle is degenerate: half
/// of the digits, beyond which the gradients of its elements are rounding.
constexpr double degenerate_area = 1e-8;
/// Throws as `check` where a triangle is wrong by itself.
void check_triangle(const TriangleMesh& mesh, std::size_t triangle);

/// Twice the area, positive where counterclockwise.
double doubled_area(const TriangleMesh& mesh, std::size_t triangle);

/// The edges of one triangle alone, in the direction of that triangle.
std::vector<std::array<std::size_t, 2>> boundary_edges(const TriangleMesh& mesh);

/// The mesh size h.
double longest_edge(const TriangleMesh& mesh);

/// A mesh with each triangle divided in four by the middles of its edges. Nodes are sorted by y and
/// then x, which keeps the neighbours in a row of the matrix near one another.
struct Refined {
  TriangleMesh mesh;
  /// For each node of `mesh`, the two nodes of the coarser mesh whose midpoint it is; the same one
  /// twice where it is a node of that mesh.
  std::vector<std::array<std::size_t, 2>> parents;
};
/// `onto_boundary` moves the middle of a boundary edge onto a curved boundary; empty: it stays.
Refined refined(const TriangleMesh& mesh, const std::function<Point(Point)>& onto_boundary = {});

}  // namespace odeum::fem
