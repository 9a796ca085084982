// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "odeum/scene/model/scene.hpp"

/// Momenta of particles of masses m (kg) in the state y: all positions (m), then all velocities
/// (m/s). Particles that are fixed have no velocity there, and add nothing.
namespace odeum::scene {

/// kg m/s
inline Vec3 linear_momentum(const std::vector<double>& m, const double* y) {
  const double* const v = y + 3 * m.size();
  Vec3 sum{};
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d) sum[d] += m[i] * v[3 * i + d];
  return sum;
}

/// About the origin, kg m^2/s.
inline Vec3 angular_momentum(const std::vector<double>& m, const double* y) {
  Vec3 sum{};
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double *q = y + 3 * i, *v = y + 3 * (m.size() + i);
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
      sum[d] += m[i] * (q[e] * v[f] - q[f] * v[e]);
    }
  }
  return sum;
}

}  // namespace odeum::scene
