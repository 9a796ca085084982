// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/scene/springs/spring_grid.hpp"

namespace odeum::bench {

/// The grid kernel of a cloth's forces on its own, with the scene's state in its layout.
template <class Real>
struct GridForces {
  scene::GridLayout layout;
  scene::GridSprings<Real> springs;
  std::vector<Real> q, v, f;

  explicit GridForces(const scene::Scene& scene) : GridForces(scene, scene::require_grid(scene)) {}
  GridForces(const scene::Scene& scene, const scene::GridStructure& grid)
      : layout(grid.rows, grid.columns),
        springs(layout, grid.kinds),
        q(3 * layout.size),
        v(q),
        f(q) {
    std::vector<double> positions, velocities;
    for (const auto& p : scene.particles)
      for (int d = 0; d < 3; ++d) {
        positions.push_back(p.position[d]);
        velocities.push_back(p.velocity[d]);
      }
    layout.scatter(positions.data(), q.data());
    layout.scatter(velocities.data(), v.data());
  }
  void forces() { springs.forces(q.data(), v.data(), f.data(), 0, layout.rows); }
};

}  // namespace odeum::bench
