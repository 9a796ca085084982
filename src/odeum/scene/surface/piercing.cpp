// SPDX-License-Identifier: BSD-3-Clause
// Edges that go through triangles at one time: no start for a potential that keeps sides.
#include "odeum/scene/surface/cells.hpp"
#include "odeum/scene/surface/surfaces.hpp"

namespace odeum::scene {
namespace {

/// Whether the segment from a to b meets the triangle: Cramer's rule for a + s (b - a) =
/// x0 + u (x1 - x0) + v (x2 - x0). One that lies in its plane does not.
bool pierces(const double* a, const double* b, const double* x0, const double* x1,
             const double* x2) {
  Vec<double> along, e1, e2, r;
  for (std::size_t d = 0; d < 3; ++d)
    along[d] = b[d] - a[d], e1[d] = x1[d] - x0[d], e2[d] = x2[d] - x0[d], r[d] = a[d] - x0[d];
  const Vec<double> p = across(along, e2), q = across(r, e1);
  const double determinant = dot(e1, p);
  if (determinant == 0) return false;
  const double u = dot(r, p) / determinant, v = dot(along, q) / determinant;
  const double s = dot(e2, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && s >= 0 && s <= 1;
}

}  // namespace

std::optional<Pierced> Surfaces::pierced(const double* q) const {
  const auto boxes_of = [&](const std::vector<Part>& parts) {
    std::vector<Box> boxes(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const std::uint32_t corner : parts[i].x) boxes[i].add(q + 3 * corner);
    return boxes;
  };
  const std::vector<Box> faces = boxes_of(triangles_), edges = boxes_of(edges_);
  const Cells cells(faces, 0, edges);
  std::optional<Pierced> first;
  for (std::size_t i = 0; i < edges.size() && !first; ++i)
    cells.visit(edges[i], 0, [&](std::size_t j) {
      const auto [a, b, same] = edges_[i].x;
      const auto& face = triangles_[j].x;
      for (const std::uint32_t corner : face)
        if (corner == a || corner == b) return;
      if (!first &&
          pierces(q + 3 * a, q + 3 * b, q + 3 * face[0], q + 3 * face[1], q + 3 * face[2]))
        first = Pierced{{a, b}, face, edges_[i].surface};
    });
  return first;
}

}  // namespace odeum::scene
