// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "odeum/scene/springs/spring_grid.hpp"

namespace odeum::scene {

/// Where a cloth on a regular grid is and what its particles are, in the kernel's own layout: what
/// every way to step one has in common. Arrays have three components of GridLayout.
template <class Real>
struct ClothState {
  using Arrays = std::vector<Real>;
  GridLayout layout;
  Arrays mass, inverse_mass, gravity;  ///< by place; zero where fixed and in the margins
  Arrays q, v;                         ///< positions (m) and velocities (m/s)

  ClothState(const Scene& scene, const GridStructure& grid)
      : layout(grid.rows, grid.columns),
        mass(collect(scene, [](const Particle& p, std::size_t) { return p.fixed ? 0 : p.mass; })),
        inverse_mass(collect(
            scene, [](const Particle& p, std::size_t) { return p.fixed ? 0 : 1 / p.mass; })),
        gravity(collect(scene, [&](const Particle& p,
                                   std::size_t d) { return p.fixed ? 0 : scene.gravity[d]; })),
        q(collect(scene, [](const Particle& p, std::size_t d) { return p.position[d]; })),
        v(collect(scene, [](const Particle& p, std::size_t d) { return p.velocity[d]; })) {}

  std::size_t particles() const { return layout.rows * layout.columns; }
  /// All positions x y z (m), then all velocities (m/s): 6 numbers a particle.
  void read(double* y) const {
    layout.gather(q.data(), y);
    layout.gather(v.data(), y + 3 * particles());
  }
  /// Calls update(i) for every place of a row in each of the three components.
  template <class Update>
  void each(std::size_t row, Update&& update) const {
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t begin = d * layout.size + layout.row(row), end = begin + layout.columns;
#pragma GCC ivdep
      for (std::size_t i = begin; i < end; ++i) update(i);
    }
  }

 private:
  template <class Of>
  Arrays collect(const Scene& scene, Of&& of) const {
    std::vector<double> numbers;
    for (const Particle& particle : scene.particles)
      for (std::size_t d = 0; d < 3; ++d) numbers.push_back(of(particle, d));
    Arrays arrays(3 * layout.size);
    layout.scatter(numbers.data(), arrays.data());
    return arrays;
  }
};

}  // namespace odeum::scene
