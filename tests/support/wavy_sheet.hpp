// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <cmath>

#include "odeum/scene/read/reader.hpp"

namespace odeum::tests {

/// A sheet of n x n in waves, as the surface of a scene.
inline scene::Scene wavy(std::size_t n, double height) {
  scene::Scene scene =
      scene::read_scene("s.yaml",
                        fmt::format("duration: 1\nsolver: {{type: rk4, timestep: "
                                    "0.001}}\ncloth: [{{rows: {0}, columns: {0}, "
                                    "row_edge: [1, 0, 0], column_edge: [0, 1, 0], mass: 1, "
                                    "structural: {{stiffness: 10}}, "
                                    "self_contact: {{thickness: 0.06, stiffness: 10}}}}]\n",
                                    n))
          .scene;
  for (scene::Particle& particle : scene.particles) {
    const double x = particle.position[0];
    particle.position[0] = 0.1 * x + 0.15 * std::sin(14 * x + particle.position[1]);
    particle.position[2] = height * x;
  }
  return scene;
}

}  // namespace odeum::tests
