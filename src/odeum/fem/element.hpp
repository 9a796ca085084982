// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "odeum/fem/elliptic.hpp"

namespace odeum::fem {

using ElementMatrix = std::array<std::array<double, 3>, 3>;

/// A linear triangle.
struct Element {
  std::array<Point, 3> nodes;
  /// For each node, the difference (a.y - b.y, b.x - a.x) of the two others, which is twice the
  /// area times the gradient of the node's basis function.
  std::array<Point, 3> turned;
  double area;

  /// Throws MeshError where the triangle is degenerate or inverted.
  Element(const TriangleMesh& mesh, std::size_t triangle) {
    for (std::size_t k = 0; k < 3; ++k) nodes[k] = mesh.nodes[mesh.triangles[triangle][k]];
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = nodes[(k + 1) % 3], b = nodes[(k + 2) % 3];
      turned[k] = {a.y - b.y, b.x - a.x};
      longest = std::max(longest, turned[k].x * turned[k].x + turned[k].y * turned[k].y);
    }
    area = (turned[2].y * turned[1].x - turned[1].y * turned[2].x) / 2;
    if (!(2 * area > degenerate_area * longest)) check_triangle(mesh, triangle);
  }

  /// The point with these barycentric coordinates.
  Point at(const std::array<double, 3>& barycentric) const {
    return {
        barycentric[0] * nodes[0].x + barycentric[1] * nodes[1].x + barycentric[2] * nodes[2].x,
        barycentric[0] * nodes[0].y + barycentric[1] * nodes[1].y + barycentric[2] * nodes[2].y};
  }

  /// Integrals of grad i . a grad j for a constant tensor.
  ElementMatrix stiffness(const Tensor& a) const {
    const double scale = 0.25 / area;
    const auto entry = [&](const Point& l, const Point& r) {
      return scale * (a.xx * l.x * r.x + a.xy * (l.x * r.y + l.y * r.x) + a.yy * l.y * r.y);
    };
    ElementMatrix matrix;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      matrix[i][i] = entry(turned[i], turned[i]);
      matrix[i][j] = matrix[j][i] = entry(turned[i], turned[j]);
    }
    return matrix;
  }
};

}  // namespace odeum::fem
