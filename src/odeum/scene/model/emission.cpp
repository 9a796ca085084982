// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/model/emission.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace odeum::scene {
namespace {

// SplitMix64 (Steele, Lea, Flood 2014): one well-mixed number for each input.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

double unit(std::uint64_t x) { return static_cast<double>(mixed(x) >> 11U) * 0x1p-53; }

// Uniform over the part of the sphere around `v` within the angle.
Vec3 turned(const Vec3& v, double spread, double first, double second) {
  const double speed = std::hypot(v[0], v[1], v[2]);
  if (speed == 0 || spread == 0) return v;
  const Vec3 axis{v[0] / speed, v[1] / speed, v[2] / speed};
  // A first perpendicular vector, from the coordinate axis with the largest angle to `axis`.
  std::size_t least = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(axis[d]) < std::abs(axis[least])) least = d;
  Vec3 across{};
  for (std::size_t d = 0; d < 3; ++d) across[d] = (d == least ? 1 : 0) - axis[least] * axis[d];
  const double length = std::hypot(across[0], across[1], across[2]);
  for (double& component : across) component /= length;
  const Vec3 third{axis[1] * across[2] - axis[2] * across[1],
                   axis[2] * across[0] - axis[0] * across[2],
                   axis[0] * across[1] - axis[1] * across[0]};
  const double cosine = 1 - first * (1 - std::cos(spread));
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double angle = 2 * std::numbers::pi * second;
  Vec3 result{};
  for (std::size_t d = 0; d < 3; ++d)
    result[d] = speed * (cosine * axis[d] +
                         sine * (std::cos(angle) * across[d] + std::sin(angle) * third[d]));
  return result;
}

}  // namespace

std::vector<EmittedParticle> emitted_particles(const std::vector<Emitter>& emitters, double until) {
  std::vector<EmittedParticle> all;
  for (std::size_t e = 0; e < emitters.size(); ++e) {
    const Emitter& emitter = emitters[e];
    const std::uint64_t stream = mixed(emitter.seed) ^ mixed(e + 1);
    for (std::uint64_t k = 0;; ++k) {
      const double birth = static_cast<double>(k) / emitter.rate;
      if (!(birth < until)) break;
      EmittedParticle one;
      one.birth = birth;
      one.death = birth + emitter.lifetime;
      one.emitter = e;
      one.particle.position = emitter.position;
      one.particle.velocity =
          turned(emitter.velocity, emitter.spread, unit(stream + 2 * k), unit(stream + 2 * k + 1));
      one.particle.mass = emitter.mass;
      all.push_back(one);
    }
  }
  std::ranges::stable_sort(all, [](const auto& l, const auto& r) { return l.birth < r.birth; });
  return all;
}

Scene at_start(const Scene& scene) {
  Scene result = scene;
  for (const auto& born : emitted_particles(scene.emitters, std::numeric_limits<double>::min()))
    result.particles.push_back(born.particle);
  return result;
}

WholeScene with_all_particles(Scene scene, double until) {
  WholeScene whole;
  whole.lives.resize(scene.size());
  for (const EmittedParticle& one : emitted_particles(scene.emitters, until)) {
    Particle particle = one.particle;
    for (std::size_t d = 0; d < 3; ++d) particle.position[d] -= one.birth * particle.velocity[d];
    scene.particles.push_back(particle);
    whole.lives.push_back({one.birth, one.death});
  }
  scene.emitters.clear();
  whole.scene = std::move(scene);
  return whole;
}

}  // namespace odeum::scene
