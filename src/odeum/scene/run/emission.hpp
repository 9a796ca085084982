// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/scene/model/scene.hpp"

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

}  // namespace odeum::scene
