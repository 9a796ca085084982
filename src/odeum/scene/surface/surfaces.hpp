// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "odeum/scene/surface/surface_law.hpp"

namespace odeum::scene {

/// Two parts of surfaces, by particle: with x_k the place of the k-th, e1 = x1 - x0, r = x2 - x0,
/// and e2 = x3 - x0 for a triangle 0, 1, 3 and a point or ball 2, x3 - x2 for the edges 0, 1 and
/// 2, 3. A corner 0 and a ball 2 have r alone; 1 is 0, and 3 is 2.
struct SurfacePair {
  enum class Kind : std::uint8_t { triangle, edges, corner };
  std::array<std::uint32_t, 4> x{};
  Kind kind = Kind::triangle;
  std::uint32_t law = 0;  ///< of Surfaces
  double radius = 0;      ///< of the ball; 0: a point
  double distance = 0;    ///< lower bound, m
  /// Lower bound of Surfaces::shrinks times how far particles move until a force acts, m.
  double slack = 0;
};

/// An edge that goes through a triangle, by particle, and the surface of the edge.
struct Pierced {
  std::array<std::uint32_t, 2> edge{};
  std::array<std::uint32_t, 3> triangle{};
  std::uint32_t surface = 0;
};

/// The surfaces of a scene as points, edges and triangles, and what of them may meet.
class Surfaces {
 public:
  explicit Surfaces(const Scene& scene);

  /// The pairs with a slack of at most a margin (m), or, where `to` is another place, that may be
  /// nearer to each other than the thickness and the margin anywhere on the straight way from q to
  /// `to`; without those that share a particle and those that are fixed. Always in the same order.
  void find_near(const double* q, const double* to, double margin,
                 std::vector<SurfacePair>& pairs) const;
  void find_near(const double* q, double margin, std::vector<SurfacePair>& pairs) const {
    find_near(q, q, margin, pairs);
  }

  /// The first edge that goes through a triangle at the places q; without pairs that share a
  /// particle.
  std::optional<Pierced> pierced(const double* q) const;

  /// Identifies the surfaces; copies share it.
  std::uint64_t id() const { return id_; }
  /// How many numbers the positions of all particles have.
  std::size_t numbers() const { return 3 * fixed_.size(); }
  const SelfContact& law(std::uint32_t index) const { return laws_[index]; }
  double thickness() const { return thickness_; }  ///< the largest
  const std::vector<std::uint32_t>& points() const { return points_; }
  const std::vector<std::uint32_t>& balls() const { return balls_; }
  std::size_t edges() const { return edges_.size(); }
  std::size_t triangles() const { return triangles_.size(); }
  /// A pair's distance and slack shrink by at most this when its particles move by 1.
  static constexpr double shrinks = 2 + 4 * reach;

 private:
  struct Part {
    std::array<std::uint32_t, 3> x{};  ///< an edge has two
    std::uint32_t surface = 0;
  };
  std::uint32_t law_of(const Part& a, const Part& b) const {
    return a.surface * surfaces_ + b.surface;
  }
  bool all_fixed(const SurfacePair& pair) const;
  class Sieve;
  template <class Take>
  void find_edges(const double* q, const double* to, double margin, const Take& take) const;
  template <class Take>
  void find_points(const double* q, const double* to, double margin, const Take& take) const;
  void find_balls(const double* q, const double* to, double margin,
                  std::vector<SurfacePair>& pairs) const;

  std::uint64_t id_;  ///< an address may be that of others that have gone
  std::uint32_t surfaces_ = 0;
  std::vector<SelfContact> laws_;  ///< by surface and surface
  std::vector<std::uint32_t> points_, balls_;
  std::vector<Part> corners_, edges_, triangles_;
  std::vector<double> radius_;  ///< by particle
  std::vector<bool> fixed_;
  double thickness_ = 0;
};

/// e1, e2 and r of a pair, of places or velocities.
template <class Real>
void differences_of(const SurfacePair& pair, const Real* q, Vec<Real>& e1, Vec<Real>& e2,
                    Vec<Real>& r) {
  const Real* const x[] = {q + 3 * pair.x[0], q + 3 * pair.x[1], q + 3 * pair.x[2],
                           q + 3 * pair.x[3]};
  const Real* const base = pair.kind == SurfacePair::Kind::triangle ? x[0] : x[2];
  for (std::size_t k = 0; k < 3; ++k) {
    e1[k] = x[1][k] - x[0][k];
    e2[k] = x[3][k] - base[k];
    r[k] = x[2][k] - x[0][k];
  }
}

inline Meeting meeting_of(SurfacePair::Kind kind) {
  return kind == SurfacePair::Kind::triangle ? Meeting::point_and_triangle : Meeting::two_edges;
}

/// Whether a force acts between the two, which goes to `apart`.
template <class Real>
MaskOf<Real> meet(const SurfacePair& pair, const SelfContact& law, const Vec<Real>& e1,
                  const Vec<Real>& e2, const Vec<Real>& r, Apart<Real>& apart) {
  if (pair.kind == SurfacePair::Kind::corner) return meet_ball(law, pair.radius, r, apart);
  return meet(meeting_of(pair.kind), law, pair.radius, e1, e2, r, apart);
}

/// The share of x_k in r, e1 and e2, by which forces on these go to the particles.
struct Shares {
  std::array<double, 4> r, e1, e2;
};
inline Shares shares_of(SurfacePair::Kind kind) {
  if (kind == SurfacePair::Kind::triangle) return {{-1, 0, 1, 0}, {-1, 1, 0, 0}, {-1, 0, 0, 1}};
  if (kind == SurfacePair::Kind::edges) return {{-1, 0, 1, 0}, {-1, 1, 0, 0}, {0, 0, -1, 1}};
  return {{-1, 0, 1, 0}, {}, {}};
}

}  // namespace odeum::scene
