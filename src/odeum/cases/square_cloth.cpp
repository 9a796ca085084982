// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/square_cloth.hpp"

#include <cmath>

namespace odeum::cases {

scene::Scene square_cloth(std::size_t n, double stiffness, bool tension_only) {
  scene::Scene scene;
  scene.gravity = {0, -9.8, 0};
  const double total_mass = 3, damping = 0.05, throw_speed = 7.5;
  const auto edge = static_cast<double>(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      scene::Particle particle;
      particle.position = {static_cast<double>(i) / edge, static_cast<double>(j) / edge, 0};
      particle.mass = total_mass / static_cast<double>(n * n);
      particle.fixed = j == n - 1;
      if (i >= 3 && i + 3 <= n && j >= 3 && j + 3 <= n)
        particle.velocity = {throw_speed, throw_speed, throw_speed};
      scene.particles.push_back(particle);
    }
  }
  const auto join = [&](std::size_t i, std::size_t j, std::ptrdiff_t di, std::ptrdiff_t dj) {
    const auto k = static_cast<std::ptrdiff_t>(i) + di, l = static_cast<std::ptrdiff_t>(j) + dj;
    const auto size = static_cast<std::ptrdiff_t>(n);
    if (k < 0 || l < 0 || k >= size || l >= size) return;
    const std::size_t a = i * n + j, b = static_cast<std::size_t>(k * size + l);
    const auto &pa = scene.particles[a].position, &pb = scene.particles[b].position;
    scene.springs.push_back({.a = a,
                             .b = b,
                             .stiffness = stiffness,
                             .damping = damping,
                             .rest_length = std::hypot(pb[0] - pa[0], pb[1] - pa[1]),
                             .tension_only = tension_only});
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (const std::ptrdiff_t reach :
           {1, 2}) {  // half of the neighbours, so that each pair is added once
        join(i, j, 0, reach);
        join(i, j, reach, -reach);
        join(i, j, reach, 0);
        join(i, j, reach, reach);
      }
  return scene;
}

}  // namespace odeum::cases
