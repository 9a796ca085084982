// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/surface/surface_term.hpp"

#include <cmath>

#include "odeum/scene/surface/near_pairs.hpp"
#include "odeum/scene/surface/pair_lanes.hpp"
#include "odeum/scene/surface/slopes.hpp"
#include "odeum/scene/surface/surfaces.hpp"

namespace odeum::scene {
namespace {

class SurfaceContact final : public Term {
 public:
  explicit SurfaceContact(const Scene& scene) : surfaces_(scene) {
    for (const Surface& surface : scene.surfaces) friction_ |= surface.friction > 0;
  }

  const Surfaces* without_friction() const { return friction_ ? nullptr : &surfaces_; }

  TermInfo info(const Bodies&) const override {
    return {.name = "self_contact",
            .law = friction_ ? "-dphi/dd n - mu N s, phi = 0.4 k h^2 (1 - d/h)^4 h/d"
                             : "-dphi/dd n, phi = 0.4 k h^2 (1 - d/h)^4 h/d",
            .count = surfaces_.triangles(),
            .unit = "triangles",
            .velocity_dependent = friction_,
            .order_kept = order_at_surfaces};
  }

  void add(const Bodies&, const double* q, const double* v, double* force) const override {
    thread_local Quads places, rates, sum;
    const std::size_t particles = surfaces_.numbers() / 3;
    const std::vector<SurfacePair>& pairs = NearPairs::of_thread().at(surfaces_, q);
    if (pairs.empty()) return;
    to_quads(q, particles, places);
    if (friction_) to_quads(v, particles, rates);
    sum.assign(4 * particles, 0);
    const auto use = [&](const PairLanes& lanes, const LaneMask& mask, Apart<Lanes>& apart) {
      const SelfContact& law = surfaces_.law(lanes.first().law);
      if (law.friction > 0) {
        Vec<Lanes> d1, d2, dr;
        lanes.differences(rates, d1, d2, dr);
        add_friction(law, friction_speed, d1, d2, dr, apart);
      }
      lanes.add_to(sum, mask, lanes.forces_of(apart.on_r, apart.on_e1, apart.on_e2));
    };
    MeetingPairs(surfaces_, places, use).visit(pairs);
    for (std::size_t i = 0; i < particles; ++i)
      for (std::size_t d = 0; d < 3; ++d) force[3 * i + d] += sum[4 * i + d];
  }

  void add_blocks(const Bodies&, const double* q, const double* v, BlockSink& sink) const override {
    for (const SurfacePair& pair : NearPairs::of_thread().at(surfaces_, q))
      if (surfaces_.law(pair.law).friction > 0)
        add_derivatives<18>(pair, q, v, sink);
      else
        add_derivatives<9>(pair, q, v, sink);
  }

  double potential(const Bodies&, const double* q) const override {
    double sum = 0;
    Apart<double> apart;
    for (const SurfacePair& pair : NearPairs::of_thread().at(surfaces_, q)) {
      Vec<double> e1, e2, r;
      differences_of(pair, q, e1, e2, r);
      if (meet(pair, surfaces_.law(pair.law), e1, e2, r, apart)) sum += apart.energy;
    }
    return sum;
  }

 private:
  /// Exact, by differentiating what computes the forces: the unknowns are the components of r, e1
  /// and e2, and with friction their rates.
  template <std::size_t N>
  void add_derivatives(const SurfacePair& pair, const double* q, const double* v,
                       BlockSink& sink) const {
    using Real = Slopes<N>;
    const SelfContact& law = surfaces_.law(pair.law);
    Vec<double> e1, e2, r;
    differences_of(pair, q, e1, e2, r);
    Apart<double> plain;
    if (!meet(pair, law, e1, e2, r, plain)) return;
    const auto unknowns = [](const Vec<double>& x, std::size_t first) {
      return Vec<Real>{Real(x[0], first), Real(x[1], first + 1), Real(x[2], first + 2)};
    };
    Apart<Real> apart;
    meet(pair, law, unknowns(e1, 3), unknowns(e2, 6), unknowns(r, 0), apart);
    if constexpr (N == 18) {
      differences_of(pair, v, e1, e2, r);
      add_friction(law, friction_speed, unknowns(e1, 12), unknowns(e2, 15), unknowns(r, 9), apart);
    }
    const Shares share = shares_of(pair.kind);
    const std::array<const Vec<Real>*, 3> on{&apart.on_r, &apart.on_e1, &apart.on_e2};
    const std::array<const std::array<double, 4>*, 3> of{&share.r, &share.e1, &share.e2};
    // The derivative of the force on i with respect to the position (0) or velocity (9) of j.
    const auto block = [&](std::size_t i, std::size_t j, std::size_t first) {
      Mat3 sum{};
      for (std::size_t f = 0; f < 3; ++f)
        for (std::size_t x = 0; x < 3; ++x) {
          const double factor = (*of[f])[i] * (*of[x])[j];
          if (factor == 0) continue;
          for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
              sum[3 * a + b] += factor * (*on[f])[a].by[first + 3 * x + b];
        }
      return sum;
    };
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        if (acts(pair, i) && acts(pair, j))
          sink.add(pair.x[i], pair.x[j], block(i, j, 0), N == 18 ? block(i, j, N / 2) : Mat3{});
  }
  // A corner and a ball are the first and the third.
  static bool acts(const SurfacePair& pair, std::size_t k) {
    return pair.kind != SurfacePair::Kind::corner || k % 2 == 0;
  }

  Surfaces surfaces_;
  bool friction_ = false;
};

}  // namespace

std::unique_ptr<Term> make_surface_contact(const Scene& scene) {
  return std::make_unique<SurfaceContact>(scene);
}

const Surfaces* frictionless_surfaces(const Term& term) {
  const auto* const contact = dynamic_cast<const SurfaceContact*>(&term);
  return contact ? contact->without_friction() : nullptr;
}

}  // namespace odeum::scene
