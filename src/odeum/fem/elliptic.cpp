// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/elliptic.hpp"

#include <cmath>

#include "odeum/fem/element.hpp"

namespace odeum::fem {

std::vector<double> EllipticSystem::nodal(const std::vector<double>& x) const {
  std::vector<double> values = given;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (unknown[i] >= 0) values[i] = x[unknown[i]];
  return values;
}

std::vector<double> nodal_of_mean_zero(const TriangleMesh& mesh, const EllipticSystem& system,
                                       const std::vector<double>& x) {
  std::vector<double> values = system.nodal(x);
  double sum = 0, area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double part = doubled_area(mesh, t) / 2;
    area += part;
    for (const std::size_t i : mesh.triangles[t]) sum += part / 3 * values[i];
  }
  for (double& value : values) value -= sum / area;
  return values;
}

linear::SparseMatrix mass_matrix(const TriangleMesh& mesh) {
  std::vector<linear::Triplet> entries;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = doubled_area(mesh, t) / 2;
    for (const std::size_t i : mesh.triangles[t])
      for (const std::size_t j : mesh.triangles[t])
        entries.push_back({static_cast<int>(i), static_cast<int>(j), area * (i == j ? 2 : 1) / 12});
  }
  const auto n = static_cast<int>(mesh.nodes.size());
  return linear::from_triplets(n, n, entries);
}

linear::SparseMatrix prolongation(const Refined& refined, const EllipticSystem& coarse,
                                  const EllipticSystem& fine) {
  std::vector<linear::Triplet> entries;
  for (std::size_t i = 0; i < refined.parents.size(); ++i)
    if (fine.unknown[i] >= 0)
      for (const std::size_t parent :
           refined.parents[i])  // both halves of a node of the coarse one
        if (coarse.unknown[parent] >= 0)
          entries.push_back({fine.unknown[i], coarse.unknown[parent], 0.5});
  return linear::from_triplets(static_cast<int>(fine.right.size()),
                               static_cast<int>(coarse.right.size()), entries);
}

FieldErrors field_errors(const TriangleMesh& mesh, const std::vector<double>& nodal,
                         const std::function<double(Point)>& value,
                         const std::function<Point(Point)>& gradient) {
  FieldErrors errors;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Element element(mesh, t);
    const auto& ids = mesh.triangles[t];
    Point slope;
    for (std::size_t i = 0; i < 3; ++i) {
      slope.x += nodal[ids[i]] * (element.turned[i].x / (2 * element.area));
      slope.y += nodal[ids[i]] * (element.turned[i].y / (2 * element.area));
      errors.maximum =
          std::fmax(errors.maximum, std::abs(nodal[ids[i]] - value(mesh.nodes[ids[i]])));
    }
    for (const Rule::Node& node : degree_5_rule().nodes) {
      const Point at = element.at(node.at), exact = gradient(at);
      double found = -value(at);
      for (std::size_t i = 0; i < 3; ++i) found += node.at[i] * nodal[ids[i]];
      const double weight = node.weight * element.area;
      errors.l2 += weight * found * found;
      errors.h1 += weight * (std::pow(slope.x - exact.x, 2) + std::pow(slope.y - exact.y, 2));
      errors.maximum = std::fmax(errors.maximum, std::abs(found));
    }
  }
  errors.l2 = std::sqrt(errors.l2), errors.h1 = std::sqrt(errors.h1);
  return errors;
}

}  // namespace odeum::fem
