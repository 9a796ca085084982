// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

namespace odeum::fem {

/// A quadrature rule on a triangle.
struct Rule {
  struct Node {
    std::array<double, 3> at;  ///< barycentric coordinates
    double weight;             ///< the weights add up to 1: times the area
  };
  const char* name;
  int degree;  ///< of the polynomials that it integrates exactly
  std::vector<Node> nodes;
};

const Rule& one_point_rule();  ///< the middle, degree 1
const Rule& vertex_rule();     ///< the corners, degree 1
/// Seven nodes, degree 5 (Radon 1948; Strang and Fix, An Analysis of the Finite Element Method,
/// table 4.1).
const Rule& degree_5_rule();

}  // namespace odeum::fem
