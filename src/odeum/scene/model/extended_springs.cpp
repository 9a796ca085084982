// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/model/extended_springs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace odeum::scene {
namespace {

using Real = ExtendedProblem::real;

void spring_force(const Spring& spring, const Real* q, const Real* v, Real* force) {
  const std::size_t a = 3 * spring.a, b = 3 * spring.b;
  std::array<Real, 3> d{};
  Real squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = q[b + i] - q[a + i];
    squared += d[i] * d[i];
  }
  const Real length = std::sqrt(squared);
  const bool slack = (spring.tension_only && length <= spring.rest_length) || length == 0;
  const Real s = slack ? 0 : spring.stiffness * (1 - spring.rest_length / length);
  for (std::size_t i = 0; i < 3; ++i) {
    const Real f = s * d[i] + spring.damping * (v[b + i] - v[a + i]);
    force[a + i] += f;
    force[b + i] -= f;
  }
}

}  // namespace

ExtendedProblem extended_mass_spring(const Scene& scene) {
  ExtendedProblem problem;
  const std::vector<double> start = start_of(scene);
  problem.y0.assign(start.begin(), start.end());
  problem.f = [scene](Real, const Real* y, Real* dydt) {
    const std::size_t n = 3 * scene.size();
    std::copy(y + n, y + 2 * n, dydt);
    Real* const a = dydt + n;
    std::fill(a, a + n, Real(0));
    for (const Spring& spring : scene.springs) spring_force(spring, y, y + n, a);
    for (std::size_t p = 0; p < scene.size(); ++p) {
      const Particle& particle = scene.particles[p];
      for (std::size_t i = 0; i < 3; ++i) {
        Real& component = a[3 * p + i];
        component = particle.fixed ? 0 : component / particle.mass + scene.gravity[i];
      }
    }
  };
  return problem;
}

}  // namespace odeum::scene
