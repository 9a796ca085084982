// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/surface/surfaces.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "odeum/scene/surface/cells.hpp"

namespace odeum::scene {
namespace {

using Place = Vec<double>;

/// Of corners (m) that an edge or a triangle has, drawn out of their mean by `reach`.
template <std::size_t N>
std::array<Place, N> drawn_out(const std::array<std::uint32_t, 3>& x, const double* q) {
  std::array<Place, N> corners{};
  for (std::size_t d = 0; d < 3; ++d) {
    double mean = 0;
    for (std::size_t k = 0; k < N; ++k) mean += q[3 * x[k] + d] / N;
    for (std::size_t k = 0; k < N; ++k)
      corners[k][d] = mean + (1 + N * reach) * (q[3 * x[k] + d] - mean);
  }
  return corners;
}

template <std::size_t N>
void cover(Box& box, const std::array<std::uint32_t, 3>& x, const double* q) {
  for (const Place& corner : drawn_out<N>(x, q)) box.add(corner.data());
}

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

bool shares_particle(const std::array<std::uint32_t, 4>& x) {
  return x[0] == x[2] || x[0] == x[3] || x[1] == x[2] || x[1] == x[3];
}

/// The smallest distance of two segments, by clamping.
double distance_of(const std::array<Place, 2>& a, const std::array<Place, 2>& b) {
  Place e1, e2, r;
  for (std::size_t d = 0; d < 3; ++d)
    e1[d] = a[1][d] - a[0][d], e2[d] = b[1][d] - b[0][d], r[d] = b[0][d] - a[0][d];
  const double aa = dot(e1, e1), ab = dot(e1, e2), bb = dot(e2, e2);
  const double ar = dot(e1, r), br = dot(e2, r), determinant = aa * bb - ab * ab;
  double s = determinant > 0 ? std::clamp((ar * bb - ab * br) / determinant, 0.0, 1.0) : 0;
  double t = bb > 0 ? (ab * s - br) / bb : 0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = aa > 0 ? std::clamp((ab * t + ar) / aa, 0.0, 1.0) : 0;
  }
  double squared = 0;
  for (std::size_t d = 0; d < 3; ++d) squared += std::pow(r[d] + t * e2[d] - s * e1[d], 2);
  return std::sqrt(squared);
}

/// A lower bound of the distance of a point from a triangle that is drawn out.
double distance_of(const std::array<std::uint32_t, 3>& x, std::uint32_t point, const double* q) {
  Place e1, e2, r, w;
  for (std::size_t d = 0; d < 3; ++d) {
    const double corner = q[3 * x[0] + d];
    e1[d] = q[3 * x[1] + d] - corner, e2[d] = q[3 * x[2] + d] - corner;
    r[d] = q[3 * point + d] - corner;
  }
  const double a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2), twice = a * c - b * b;
  if (!(twice > 0)) return 0;
  const double u = (c * dot(e1, r) - b * dot(e2, r)) / twice;
  const double v = (a * dot(e2, r) - b * dot(e1, r)) / twice;
  for (std::size_t d = 0; d < 3; ++d) w[d] = r[d] - u * e1[d] - v * e2[d];
  // Beyond a side by so many heights of the triangle, which are twice its area by the side.
  const double beyond = std::max({0.0, (-u - reach) / std::sqrt(c), (-v - reach) / std::sqrt(a),
                                  (u + v - 1 - reach) / std::sqrt(a - 2 * b + c)});
  return std::sqrt(dot(w, w) + beyond * beyond * twice);
}

}  // namespace

Surfaces::Surfaces(const Scene& scene)
    : id_(next_id()), surfaces_(static_cast<std::uint32_t>(scene.surfaces.size())) {
  for (const Surface& a : scene.surfaces)
    for (const Surface& b : scene.surfaces) {
      laws_.push_back({.thickness = (a.thickness + b.thickness) / 2,
                       .stiffness = (a.stiffness + b.stiffness) / 2,
                       .friction = (a.friction + b.friction) / 2});
      thickness_ = std::max(thickness_, laws_.back().thickness);
    }
  std::vector<bool> on_surface(scene.size());
  for (std::uint32_t s = 0; s < surfaces_; ++s) {
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<std::uint32_t> points;
    for (const auto& face : scene.surfaces[s].faces) {
      Part triangle{.surface = s};
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.x[k] = static_cast<std::uint32_t>(face[k]);
        points.push_back(triangle.x[k]);
        on_surface[face[k]] = true;
        const auto next = static_cast<std::uint32_t>(face[(k + 1) % 3]);
        edges.push_back({std::min(triangle.x[k], next), std::max(triangle.x[k], next)});
      }
      triangles_.push_back(triangle);
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& edge : edges) edges_.push_back({{edge[0], edge[1], edge[1]}, s});
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const std::uint32_t point : points) corners_.push_back({{point, point, point}, s});
    points_.insert(points_.end(), points.begin(), points.end());
  }
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    const Particle& particle = scene.particles[i];
    radius_.push_back(particle.radius);
    fixed_.push_back(particle.fixed);
    if (particle.radius > 0 && !on_surface[i]) balls_.push_back(i);
  }
}

bool Surfaces::all_fixed(const SurfacePair& pair) const {
  return std::ranges::all_of(pair.x, [&](std::uint32_t i) { return fixed_[i]; });
}

void Surfaces::find_near(const double* q, const double* to, double margin,
                         std::vector<SurfacePair>& pairs) const {
  pairs.clear();
  find_points(q, to, margin, pairs);
  find_edges(q, to, margin, pairs);
  find_balls(q, to, margin, pairs);
}

void Surfaces::find_edges(const double* q, const double* to, double margin,
                          std::vector<SurfacePair>& pairs) const {
  std::vector<Box> boxes(edges_.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    cover<2>(boxes[i], edges_[i].x, q);
    if (to != q) cover<2>(boxes[i], edges_[i].x, to);
  }
  const Cells cells(boxes, thickness_ + margin);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Part& a = edges_[i];
    cells.visit(boxes[i], i + 1, [&](std::size_t j) {
      const Part& b = edges_[j];
      SurfacePair pair{{a.x[0], a.x[1], b.x[0], b.x[1]}, SurfacePair::Kind::edges, law_of(a, b)};
      if (shares_particle(pair.x) || all_fixed(pair)) return;
      if (to == q)
        pair.slack =
            distance_of(drawn_out<2>(a.x, q), drawn_out<2>(b.x, q)) - laws_[pair.law].thickness;
      if (pair.slack <= margin) pairs.push_back(pair);
    });
  }
}

void Surfaces::find_points(const double* q, const double* to, double margin,
                           std::vector<SurfacePair>& pairs) const {
  std::vector<Box> boxes(corners_.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].add(q + 3 * corners_[i].x[0]);
    boxes[i].add(to + 3 * corners_[i].x[0]);
  }
  std::vector<Box> faces(triangles_.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    cover<3>(faces[i], triangles_[i].x, q);
    if (to != q) cover<3>(faces[i], triangles_[i].x, to);
  }
  const Cells cells(boxes, thickness_ + margin, faces);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Part& face = triangles_[i];
    cells.visit(faces[i], 0, [&](std::size_t j) {
      const std::uint32_t point = corners_[j].x[0];
      SurfacePair pair{{face.x[0], face.x[1], point, face.x[2]},
                       SurfacePair::Kind::triangle,
                       law_of(face, corners_[j])};
      if (point == face.x[0] || point == face.x[1] || point == face.x[2] || all_fixed(pair)) return;
      if (to == q) pair.slack = distance_of(face.x, point, q) - laws_[pair.law].thickness;
      if (pair.slack <= margin) pairs.push_back(pair);
    });
  }
}

// Few balls: each with every corner and triangle.
void Surfaces::find_balls(const double* q, const double* to, double margin,
                          std::vector<SurfacePair>& pairs) const {
  for (const std::uint32_t ball : balls_) {
    Box around;
    around.add(q + 3 * ball);
    around.add(to + 3 * ball);
    const auto add = [&](const Part& part, SurfacePair pair, const Box& box) {
      pair.law = law_of(part, part);
      pair.radius = radius_[ball];
      const double most = pair.radius + laws_[pair.law].thickness;
      if (!box.is_near(around, most + margin) || all_fixed(pair)) return;
      if (to == q) pair.slack = box.distance(around) - most;
      pairs.push_back(pair);
    };
    for (const Part& corner : corners_) {
      const std::uint32_t i = corner.x[0];
      Box box;
      box.add(q + 3 * i);
      box.add(to + 3 * i);
      add(corner, {{i, i, ball, ball}, SurfacePair::Kind::corner}, box);
    }
    for (const Part& face : triangles_) {
      Box box;
      cover<3>(box, face.x, q);
      if (to != q) cover<3>(box, face.x, to);
      add(face, {{face.x[0], face.x[1], ball, face.x[2]}, SurfacePair::Kind::triangle}, box);
    }
  }
}

}  // namespace odeum::scene
