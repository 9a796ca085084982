// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/surface/passing.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/scene/surface/near_pairs.hpp"

namespace odeum::scene {
namespace {

double volume(const Vec<double>& a, const Vec<double>& b, const Vec<double>& c) {
  return dot(across(a, b), c);
}

/// e1, e2 and r at a part of the way.
struct Straight {
  Vec<double> from[3]{}, change[3]{};

  Straight(const SurfacePair& pair, const double* q, const double* to) {
    differences_of(pair, q, from[0], from[1], from[2]);
    differences_of(pair, to, change[0], change[1], change[2]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < 3; ++d) change[i][d] -= from[i][d];
  }
  Vec<double> at(std::size_t i, double s) const {
    Vec<double> x = from[i];
    for (std::size_t d = 0; d < 3; ++d) x[d] += s * change[i][d];
    return x;
  }
  double volume_at(double s) const { return volume(at(0, s), at(1, s), at(2, s)); }
};

/// Where the volume is 0 on (0, 1], ascending: between two extremes of the cubic at most once.
std::vector<double> coplanar_at(const Straight& way) {
  const auto& [a, b, c] = way.from;
  const auto& [u, v, w] = way.change;
  const double c1 = volume(u, b, c) + volume(a, v, c) + volume(a, b, w);
  const double c2 = volume(u, v, c) + volume(u, b, w) + volume(a, v, w), c3 = volume(u, v, w);
  std::vector<double> ends{0};
  // Extremes: c1 + 2 c2 s + 3 c3 s^2 = 0.
  if (const double under = c2 * c2 - 3 * c3 * c1; under > 0) {
    const double q = -(c2 + std::copysign(std::sqrt(under), c2));
    for (const double s : {q / (3 * c3), c1 / q})
      if (s > 0 && s < 1) ends.push_back(s);
  }
  ends.push_back(1);
  std::ranges::sort(ends);
  std::vector<double> roots;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    double low = ends[i], high = ends[i + 1];
    const bool rises = way.volume_at(low) < 0;
    if (way.volume_at(low) == 0 || rises == (way.volume_at(high) < 0)) continue;
    for (int k = 0; k < 60 && high - low > 0; ++k) {
      const double middle = (low + high) / 2;
      (rises == (way.volume_at(middle) < 0) ? low : high) = middle;
    }
    roots.push_back(high);
  }
  return roots;
}

/// Whether the nearest points are on the triangle, or on both edges.
bool inside(SurfacePair::Kind kind, const Vec<double>& e1, const Vec<double>& e2,
            const Vec<double>& r) {
  const double a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2), determinant = a * c - b * b;
  // Nearly parallel lines have no crossing to speak of; the ends of the edges decide then.
  constexpr double least = 1e-3;
  if (!(determinant > (kind == SurfacePair::Kind::edges ? least * a * c : 0))) return false;
  const double u = (c * dot(e1, r) - b * dot(e2, r)) / determinant;
  const double v = (a * dot(e2, r) - b * dot(e1, r)) / determinant;
  if (kind == SurfacePair::Kind::triangle) return u >= 0 && v >= 0 && u + v <= 1;
  return u >= 0 && u <= 1 && -v >= 0 && -v <= 1;
}

bool enters_ball(const SurfacePair& pair, const Straight& way) {
  if (pair.kind != SurfacePair::Kind::corner) return false;  // corners tell
  const Vec<double>&r = way.from[2], &change = way.change[2];
  const double squared = dot(change, change), inner = pair.radius * pair.radius;
  if (!(dot(r, r) > inner)) return false;  // was inside before
  const double s = squared > 0 ? std::clamp(-dot(r, change) / squared, 0.0, 1.0) : 0;
  const Vec<double> nearest = way.at(2, s);
  return dot(nearest, nearest) <= inner;
}

}  // namespace

Touching touching_at(const Surfaces& surfaces, const double* q,
                     std::vector<std::uint32_t>* particles) {
  Touching result;
  Apart<double> apart;
  for (const SurfacePair& pair : NearPairs::of_thread().at(surfaces, q)) {
    Vec<double> e1, e2, r;
    differences_of(pair, q, e1, e2, r);
    const SelfContact& law = surfaces.law(pair.law);
    if (!meet(pair, law, e1, e2, r, apart)) continue;
    ++result.pairs;
    if (particles) particles->insert(particles->end(), pair.x.begin(), pair.x.end());
    if (const double depth = law.thickness - apart.distance; depth > result.deepest) {
      result.deepest = depth, result.thickness = law.thickness;
      result.pair = pair;
    }
  }
  return result;
}

std::vector<SurfacePair> passed_between(const Surfaces& surfaces, const double* q,
                                        const double* to) {
  NearPairs& known = NearPairs::of_thread();
  known.at(surfaces, to);
  std::vector<SurfacePair> near;
  if (known.hold_from(surfaces, q)) {
    const double moved = std::max(known.moved_to(q), known.moved_to(to));
    for (const SurfacePair& pair : known.pairs())
      if (known.may_touch(pair, moved)) near.push_back(pair);
  } else {
    surfaces.find_near(q, to, 0, near);
  }
  std::erase_if(near, [&](const SurfacePair& pair) {
    const Straight way(pair, q, to);
    if (pair.radius > 0) return !enters_ball(pair, way);
    return std::ranges::none_of(coplanar_at(way), [&](double s) {
      return inside(pair.kind, way.at(0, s), way.at(1, s), way.at(2, s));
    });
  });
  return near;
}

}  // namespace odeum::scene
