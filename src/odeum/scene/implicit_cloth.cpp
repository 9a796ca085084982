// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/implicit_cloth.hpp"

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
    : layout_(grid.rows, grid.columns),
      springs_(layout_, grid.kinds),
      matrix_(springs_, free_masses(scene).data()),
      mass_(3 * layout_.size),
      gravity_(mass_),
      q_(mass_),
      v_(mass_) {
  for (const SpringKind& kind : grid.kinds)
    if (kind.stiffness * kind.rest_length < 0)
      throw std::invalid_argument("a cloth has no spring of negative stiffness or rest length");
  std::vector<double> q, v, mass, gravity;
  for (const Particle& particle : scene.particles)
    for (std::size_t d = 0; d < 3; ++d) {
      const double m = particle.fixed ? 0 : particle.mass;
      q.push_back(particle.position[d]);
      v.push_back(particle.velocity[d]);
      mass.push_back(m);
      gravity.push_back(m * scene.gravity[d]);
    }
  layout_.scatter(q.data(), q_.data());
  layout_.scatter(v.data(), v_.data());
  layout_.scatter(mass.data(), mass_.data());
  layout_.scatter(gravity.data(), gravity_.data());
}

bool ImplicitCloth::step(double h, std::size_t steps, double relative) {
  Arrays ahead(q_.size()), right(q_.size()), change(q_.size());
  for (std::size_t n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < q_.size(); ++i) ahead[i] = q_[i] + h * v_[i];
    springs_.forces(ahead.data(), v_.data(), right.data(), 0, layout_.rows);
    for (std::size_t i = 0; i < q_.size(); ++i) {
      right[i] = mass_[i] != 0 ? h * (right[i] + gravity_[i]) : 0;
    }
    matrix_.assemble(ahead.data(), h, true);
    // The last step's change is the guess.
    if (!matrix_.solve(right.data(), change.data(), relative)) return false;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      v_[i] += change[i];
      q_[i] += h * v_[i];
    }
  }
  return true;
}

void ImplicitCloth::read(double* y) const {
  layout_.gather(q_.data(), y);
  layout_.gather(v_.data(), y + 3 * layout_.rows * layout_.columns);
}

}  // namespace odeum::scene
