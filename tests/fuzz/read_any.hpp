// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <string>

#include "fuzz/has_place.hpp"
#include "odeum/scene/read/reader.hpp"

namespace odeum::fuzz {

/// Whether the reader returns a scene of finite numbers or an error that begins with the place.
inline bool read_any(const std::string& text) {
  scene::ReadOptions options;
  options.most_particles = 20'000;
  try {
    const scene::Scene scene = scene::read_scene("f", text, options).scene;
    for (const auto& particle : scene.particles)
      for (std::size_t d = 0; d < 3; ++d)
        if (!std::isfinite(particle.position[d]) || !std::isfinite(particle.velocity[d]))
          return false;
    for (const auto& spring : scene.springs)
      if (spring.a >= scene.particles.size() || spring.b >= scene.particles.size() ||
          spring.a == spring.b || !std::isfinite(spring.rest_length))
        return false;
    return true;
  } catch (const InputError& error) {
    return has_place(error.what());
  }
}

}  // namespace odeum::fuzz
