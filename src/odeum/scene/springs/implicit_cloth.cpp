// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/springs/implicit_cloth.hpp"

#include <stdexcept>

namespace odeum::scene {
namespace {

std::vector<double> free_masses(const Scene& scene) {
  std::vector<double> masses;
  for (const Particle& particle : scene.particles)
    masses.push_back(particle.fixed ? 0 : particle.mass);
  return masses;
}

}  // namespace

ImplicitCloth::ImplicitCloth(const Scene& scene) : ImplicitCloth(scene, require_grid(scene)) {}

ImplicitCloth::ImplicitCloth(const Scene& scene, const GridStructure& grid)
    : state_(scene, grid),
      springs_(state_.layout, grid.kinds),
      matrix_(springs_, free_masses(scene).data()) {
  for (const SpringKind& kind : grid.kinds)
    if (kind.stiffness * kind.rest_length < 0)
      throw std::invalid_argument("a cloth has no spring of negative stiffness or rest length");
}

bool ImplicitCloth::step(double h, std::size_t steps, double relative) {
  Arrays &q = state_.q, &v = state_.v;
  const Arrays &mass = state_.mass, &gravity = state_.gravity;
  Arrays ahead(q.size()), right(q.size()), change(q.size());
  for (std::size_t n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < q.size(); ++i) ahead[i] = q[i] + h * v[i];
    springs_.forces(ahead.data(), v.data(), right.data(), 0, state_.layout.rows);
    for (std::size_t i = 0; i < q.size(); ++i) {
      right[i] = mass[i] != 0 ? h * (right[i] + mass[i] * gravity[i]) : 0;
    }
    matrix_.assemble(ahead.data(), h, true);
    // The last step's change is the guess.
    if (!matrix_.solve(right.data(), change.data(), relative)) return false;
    for (std::size_t i = 0; i < q.size(); ++i) {
      v[i] += change[i];
      q[i] += h * v[i];
    }
  }
  return true;
}

}  // namespace odeum::scene
