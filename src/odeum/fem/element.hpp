// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/fem/elliptic.hpp"

namespace odeum::fem {

using ElementMatrix = std::array<std::array<double, 3>, 3>;

/// A linear triangle of a valid mesh.
struct Element {
  double area;
  std::array<Point, 3> nodes, gradients;  ///< gradients of the three basis functions

  Element(const TriangleMesh& mesh, std::size_t triangle) : area(doubled_area(mesh, triangle) / 2) {
    for (std::size_t k = 0; k < 3; ++k) nodes[k] = mesh.nodes[mesh.triangles[triangle][k]];
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = nodes[(k + 1) % 3], b = nodes[(k + 2) % 3];
      gradients[k] = {(a.y - b.y) / (2 * area), (b.x - a.x) / (2 * area)};
    }
  }

  /// The point with these barycentric coordinates.
  Point at(const std::array<double, 3>& barycentric) const {
    Point p;
    for (std::size_t k = 0; k < 3; ++k)
      p.x += barycentric[k] * nodes[k].x, p.y += barycentric[k] * nodes[k].y;
    return p;
  }

  /// Integrals of grad i . a grad j for a constant tensor.
  ElementMatrix stiffness(const Tensor& a) const {
    ElementMatrix matrix;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const Point l = gradients[i], r = gradients[j];
        matrix[i][j] =
            area * (a.xx * l.x * r.x + a.xy * (l.x * r.y + l.y * r.x) + a.yy * l.y * r.y);
      }
    return matrix;
  }

  /// Integrals of the product of basis functions i and j, exactly.
  ElementMatrix mass() const {
    ElementMatrix matrix;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) matrix[i][j] = area * (i == j ? 2 : 1) / 12;
    return matrix;
  }
};

}  // namespace odeum::fem
