// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <vector>

/// A mechanical scene: particles, springs and a few uniform forces, in SI units. A case that has
/// one can be given to a physics engine, which takes bodies instead of a right-hand side.
namespace odeum::scene {

using Vec3 = std::array<double, 3>;

struct Particle {
  Vec3 position{};
  Vec3 velocity{};
  double mass = 1;
  bool fixed = false;  ///< never moves
};

/// Force stiffness * (length - rest_length) along the spring, and damping * (relative velocity).
struct Spring {
  std::size_t a = 0, b = 0;
  double stiffness = 0;       ///< N/m
  double damping = 0;         ///< N s/m, on the whole relative velocity
  double rest_length = 0;     ///< m
  bool tension_only = false;  ///< the elastic force acts only while stretched; damping always acts
};

struct Scene {
  std::vector<Particle> particles;
  std::vector<Spring> springs;
  Vec3 gravity{};  ///< m/s^2
  /// A force m * B v on every free particle, row-major 3 x 3 (1/s). Holds y' = lambda y as the
  /// motion of a particle in a medium; zero where absent.
  std::array<double, 9> velocity_matrix{};

  /// How the scene's state reads as the case's: component i of y is entry `select[i]` of
  /// [all positions x y z, all velocities x y z] (6 entries a particle in all). Empty: all of it.
  std::vector<std::size_t> select;

  std::size_t size() const { return particles.size(); }
};

/// The state that a scene starts from: all positions, then all velocities.
inline std::vector<double> start_of(const Scene& scene) {
  std::vector<double> y;
  for (const Particle& p : scene.particles) y.insert(y.end(), p.position.begin(), p.position.end());
  for (const Particle& p : scene.particles) y.insert(y.end(), p.velocity.begin(), p.velocity.end());
  return y;
}

}  // namespace odeum::scene
