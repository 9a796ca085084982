// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/surface/surfaces.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "odeum/scene/surface/cells.hpp"
#include "odeum/scene/surface/pair_lanes.hpp"

namespace odeum::scene {
namespace {

using Place = Vec<double>;

/// The corners (m) of an edge or a triangle, moved away from their mean by `reach`.
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

Lanes above_zero(const Lanes& x) { return max(x, Lanes(0.0)); }

/// How the lines or the plane and point of pairs lie, and where their nearest points are.
struct Lying {
  Vec<Lanes> e1{}, e2{}, r{};
  Lanes a = 0, b = 0, c = 0, twice = 0;  ///< twice: the square of the parallelogram's area
  Lanes u = 0, v = 0;                    ///< 0 where that is 0
  LaneMask spans{};                      ///< where it is not

  Lying(const PairLanes& pairs, const Quads& q) {
    pairs.differences(q, e1, e2, r);
    a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2), twice = a * c - b * b;
    spans = twice > 0;
    const Lanes per_twice = select(spans, 1 / twice, Lanes(0.0));
    u = (c * dot(e1, r) - b * dot(e2, r)) * per_twice;
    v = (a * dot(e2, r) - b * dot(e1, r)) * per_twice;
  }
};

Lanes per(const Lanes& x) { return select(x > 0, 1 / x, Lanes(0.0)); }
Lanes within_edge(const Lanes& x) { return min(max(x, Lanes(-reach)), Lanes(1 + reach)); }

/// The smallest distance of two edges that are drawn out, by clamping.
Lanes distance_of_edges(const Lying& at) {
  const Lanes first = (at.b * within_edge(at.u) - dot(at.e2, at.r)) * per(at.c);
  const Lanes t = within_edge(first), again = (at.b * t + dot(at.e1, at.r)) * per(at.a);
  const Lanes s = within_edge(select(abs(first - t) > 0, again, at.u));
  Vec<Lanes> apart;
  for (std::size_t d = 0; d < 3; ++d) apart[d] = at.r[d] + t * at.e2[d] - s * at.e1[d];
  return sqrt(dot(apart, apart));
}

/// A lower bound of the distance of a point from a triangle that is drawn out.
Lanes distance_of_point(const Lying& at) {
  Vec<Lanes> w;
  for (std::size_t d = 0; d < 3; ++d) w[d] = at.r[d] - at.u * at.e1[d] - at.v * at.e2[d];
  // Beyond a side by so many heights of the triangle, which are twice its area by the side.
  const Lanes beyond[] = {above_zero(-at.u - reach), above_zero(-at.v - reach),
                          above_zero(at.u + at.v - 1 - reach)};
  const Lanes squared =
      max(max(beyond[0] * beyond[0] * per(at.c), beyond[1] * beyond[1] * per(at.a)),
          beyond[2] * beyond[2] * per(at.a - 2 * at.b + at.c));
  return select(at.spans, sqrt(dot(w, w) + squared * at.twice), Lanes(0.0));
}

/// A lower bound of Surfaces::shrinks times how far particles move until the nearest point is where
/// a force acts. After a motion of m each, D from one nearest point to the other is across e1 and
/// e2, and shorter than the thickness h. Between the same points it differed by s = shrinks m at
/// most, and e1 and e2 by 2 m, so that its part along e_i was at most s (1 + 2 h / (shrinks
/// |e_i|)). That part is what lies between u, v now and after the motion.
Lanes slack_to_window(SurfacePair::Kind kind, const Lying& at, double thickness) {
  const double part = 2 * thickness / Surfaces::shrinks;
  const Lanes per1 = per(sqrt(at.a)), per2 = per(sqrt(at.c));
  const Lanes sine = at.twice * per1 * per1 * per2 * per2, cosine = abs(at.b) * per1 * per2;
  const Lanes along1 = 1 + part * per1, along2 = 1 + part * per2;
  const Lanes most1 = (along1 + cosine * along2) * per1, most2 = (along2 + cosine * along1) * per2;
  if (kind == SurfacePair::Kind::triangle)
    return sine * max(max(above_zero(-at.u - reach) / most1, above_zero(-at.v - reach) / most2),
                      above_zero(at.u + at.v - 1 - reach) / (most1 + most2));
  return sine * max(above_zero(abs(at.u - 0.5) - 0.5 - reach) / most1,
                    above_zero(abs(at.v + 0.5) - 0.5 - reach) / most2);
}

}  // namespace

/// Keeps of pairs, as many as a vector holds at once, those with little slack.
class Surfaces::Sieve {
 public:
  Sieve(const Surfaces& surfaces, const double* q, double margin, std::vector<SurfacePair>& kept)
      : surfaces_(surfaces), margin_(margin), kept_(kept) {
    to_quads(q, surfaces.fixed_.size(), places_);
  }
  // Member by member: a copy as a whole would wait for the members to be written.
  void add(const SurfacePair& pair) {
    SurfacePair& added = pairs_[count_++];
    added.x = pair.x, added.kind = pair.kind, added.law = pair.law;
    if (count_ == pairs_.size()) sift();
  }
  void sift() {
    PairLanes lanes;
    const SurfacePair *next = pairs_.data(), *const end = next + count_;
    for (SurfacePair* pair = pairs_.data(); next != end;) {
      next = lanes.take(next, end);
      lanes.fill();
      const Lying at(lanes, places_);
      const SurfacePair::Kind kind = lanes.first().kind;
      const double thickness = surfaces_.laws_[lanes.first().law].thickness;
      const Lanes distance =
          kind == SurfacePair::Kind::triangle ? distance_of_point(at) : distance_of_edges(at);
      const Lanes window = select(at.spans, slack_to_window(kind, at, thickness), Lanes(0.0));
      const Lanes slack = max(distance - thickness, window);
      for (std::size_t lane = 0; lane < lanes.count(); ++lane, ++pair) {
        pair->distance = distance[lane], pair->slack = slack[lane];
        if (!(pair->slack > margin_)) kept_.push_back(*pair);
      }
    }
    count_ = 0;
  }

 private:
  const Surfaces& surfaces_;
  double margin_;
  std::vector<SurfacePair>& kept_;
  std::array<SurfacePair, 256> pairs_;
  std::size_t count_ = 0;
  Quads places_;
};

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

template <class Take>
void Surfaces::find_edges(const double* q, const double* to, double margin,
                          const Take& take) const {
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
      if (!shares_particle(pair.x) && !all_fixed(pair)) take(pair);
    });
  }
}

template <class Take>
void Surfaces::find_points(const double* q, const double* to, double margin,
                           const Take& take) const {
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
      if (point != face.x[0] && point != face.x[1] && point != face.x[2] && !all_fixed(pair))
        take(pair);
    });
  }
}

void Surfaces::find_near(const double* q, const double* to, double margin,
                         std::vector<SurfacePair>& pairs) const {
  pairs.clear();
  Sieve sieve(*this, q, margin, pairs);
  const auto take = [&](const SurfacePair& pair) {
    to == q ? sieve.add(pair) : pairs.push_back(pair);
  };
  find_points(q, to, margin, take);
  find_edges(q, to, margin, take);
  sieve.sift();
  find_balls(q, to, margin, pairs);
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
      if (to == q) pair.distance = box.distance(around) - pair.radius;
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
