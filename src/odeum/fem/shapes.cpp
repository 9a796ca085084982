// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/shapes.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace odeum::fem {
namespace {

void require(bool enough, const char* what) {
  if (!enough) throw std::invalid_argument(what);
}
constexpr const char* too_few = "a mesh needs at least one division";

/// The cell with the lower left node `corner`, in rows of `row` nodes, in two triangles.
void add_cell(TriangleMesh& mesh, std::size_t corner, std::size_t row, bool rising) {
  const std::size_t a = corner, b = corner + 1, c = corner + row + 1, d = corner + row;
  if (rising)
    mesh.triangles.push_back({a, b, c}), mesh.triangles.push_back({a, c, d});
  else
    mesh.triangles.push_back({a, b, d}), mesh.triangles.push_back({b, c, d});
}

}  // namespace

TriangleMesh unit_square(std::size_t n) {
  require(n > 0, too_few);
  TriangleMesh mesh;
  const auto divisions = static_cast<double>(n);
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      mesh.nodes.push_back(
          {static_cast<double>(i) / divisions, static_cast<double>(j) / divisions});
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) add_cell(mesh, j * (n + 1) + i, n + 1, true);
  return mesh;
}

TriangleMesh unstructured_square(std::size_t n, std::uint64_t seed) {
  TriangleMesh mesh = unit_square(n);
  // Two edges of a corner keep at least 0.6 of the spacing along themselves and gain at most 0.4
  // across, so that an area is never below 0.6^2 - 0.4^2 = 0.2 of what it was.
  const double reach = 0.2 / static_cast<double>(n);
  std::mt19937_64 bits(seed);
  // The standard's distributions differ between libraries.
  const auto uniform = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  for (std::size_t j = 1; j < n; ++j)
    for (std::size_t i = 1; i < n; ++i) {
      Point& node = mesh.nodes[j * (n + 1) + i];
      node.x += reach * (2 * uniform() - 1);
      node.y += reach * (2 * uniform() - 1);
    }
  mesh.triangles.clear();
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) add_cell(mesh, j * (n + 1) + i, n + 1, uniform() < 0.5);
  return mesh;
}

TriangleMesh l_shape(std::size_t n) {
  require(n > 0, too_few);
  TriangleMesh mesh;
  const std::size_t row = 2 * n + 1;
  std::vector<std::size_t> place;  // by node of the whole square
  for (std::size_t j = 0; j < row; ++j)
    for (std::size_t i = 0; i < row; ++i) {
      place.push_back(mesh.nodes.size());
      if (i <= n || j >= n)
        mesh.nodes.push_back({static_cast<double>(i) / static_cast<double>(n) - 1,
                              static_cast<double>(j) / static_cast<double>(n) - 1});
    }
  for (std::size_t j = 0; j < 2 * n; ++j)
    for (std::size_t i = 0; i < 2 * n; ++i)
      if (i < n || j >= n) add_cell(mesh, j * row + i, row, true);
  for (auto& ids : mesh.triangles)
    for (std::size_t& id : ids) id = place[id];
  return mesh;
}

TriangleMesh polygon(std::size_t corners) {
  require(corners > 2, "a polygon needs at least three corners");
  TriangleMesh mesh;
  mesh.nodes.push_back({0, 0});
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    mesh.nodes.push_back({std::cos(angle), std::sin(angle)});
    mesh.triangles.push_back({0, k + 1, (k + 1) % corners + 1});
  }
  return mesh;
}

Point onto_unit_circle(Point p) {
  const double r = std::hypot(p.x, p.y);
  return {p.x / r, p.y / r};
}

}  // namespace odeum::fem
