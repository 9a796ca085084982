// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <random>
#include <vector>

#include "odeum/scene/problem/scene_problem.hpp"

namespace odeum::tests {

/// A net of n x n particles in the unit square, perturbed: positions and velocities by up to
/// `disorder` (m, m/s), masses and springs all different, springs along rows, columns and one
/// diagonal, every third one tension-only. `fixed` of the particles do not move.
inline scene::Scene disordered_net(std::size_t n, double disorder, std::size_t fixed,
                                   double stiffness = 10, double damping = 0.05) {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> moved(-disorder, disorder), factor(0.5, 1.5);
  const auto draw = [&](auto& distribution) { return distribution(random); };
  scene::Scene scene;
  scene.gravity = {0.3, -9.8, 0.1};
  const double spacing = 1 / static_cast<double>(n - 1);
  for (std::size_t i = 0; i < n * n; ++i) {
    scene::Particle particle;
    const std::size_t row = i / n;
    particle.position = {static_cast<double>(row) * spacing + draw(moved),
                         static_cast<double>(i % n) * spacing + draw(moved), draw(moved)};
    particle.fixed = i < fixed;
    if (!particle.fixed) particle.velocity = {draw(moved), draw(moved), draw(moved)};
    particle.mass = 0.1 * draw(factor);
    scene.particles.push_back(particle);
  }
  const auto join = [&](std::size_t a, std::size_t b, double length) {
    scene.springs.push_back({.a = a,
                             .b = b,
                             .stiffness = stiffness * draw(factor),
                             .damping = damping * draw(factor),
                             .rest_length = length,
                             .tension_only = scene.springs.size() % 3 == 0});
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (i + 1 < n) join(i * n + j, (i + 1) * n + j, spacing);
      if (j + 1 < n) join(i * n + j, i * n + j + 1, spacing);
      if (i + 1 < n && j + 1 < n) join(i * n + j, (i + 1) * n + j + 1, std::sqrt(2.) * spacing);
    }
  }
  return scene;
}

}  // namespace odeum::tests
