// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <vector>

#include "odeum/scene/model/scene.hpp"

/// Particles that emitters add to a scene.
namespace odeum::scene {

/// An emitted particle, which exists from `birth` to `death`, s.
struct EmittedParticle {
  double birth = 0, death = 0;
  std::size_t emitter = 0;
  Particle particle;
};

/// All particles born before `until`, by time of birth (those of one time in the order of their
/// emitters): number k of an emitter at k / rate, its direction uniform in the cone of `spread`
/// around the emitter's velocity. The same seed gives the same particles on every machine.
std::vector<EmittedParticle> emitted_particles(const std::vector<Emitter>& emitters, double until);

/// The scene at time 0: with the particles that are emitted then.
Scene at_start(const Scene& scene);

/// From when to when the forces of a scene act on a particle, s.
struct Lifetime {
  double birth = -std::numeric_limits<double>::infinity();
  double death = std::numeric_limits<double>::infinity();
  bool holds(double t) const { return birth <= t && t < death; }
};

/// A scene without emitters that has all particles from the start: those not yet born fly straight,
/// with the velocity of their birth, so that they are at their emitter in time, and on after their
/// death. The number of particles stays the same, and the motion of each is that of the scene as
/// long as it lives. The listed particles come first.
struct WholeScene {
  Scene scene;
  std::vector<Lifetime> lives;  ///< by particle
};
WholeScene with_all_particles(Scene scene, double until);

}  // namespace odeum::scene
