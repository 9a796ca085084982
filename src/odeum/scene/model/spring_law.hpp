// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "odeum/scene/model/scene.hpp"

/// The law of a spring, in any floating-point type. With x = x_b - x_a, l = |x|, u = x / l and
/// w = v_b - v_a, the force on a, whose opposite acts on b, is
///
///     k (l - L) u + d w,   or where the damping is axial   [k (l - L) + d (w.u)] u.
///
/// A slack tension-only spring has no elastic force, and one of zero length, whose direction is
/// undefined, has neither that nor axial damping. Vector kernels (springs/) are tested against it.
namespace odeum::scene {

template <class Real>
Real length_of(const std::array<Real, 3>& x) {
  return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}
template <class Real>
std::array<Real, 3> difference(const Real* a, const Real* b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

/// k (1 - L/l): the elastic force is this times x.
template <class Real>
Real elastic_factor(const Spring& spring, Real length) {
  const bool slack = (spring.tension_only && length <= spring.rest_length) || length == 0;
  return slack ? 0 : spring.stiffness * (1 - spring.rest_length / length);
}

/// The force on a, N.
template <class Real>
std::array<Real, 3> spring_force(const Spring& spring, const std::array<Real, 3>& x,
                                 const std::array<Real, 3>& w) {
  const Real length = length_of(x), s = elastic_factor(spring, length);
  if (!spring.axial)
    return {s * x[0] + spring.damping * w[0], s * x[1] + spring.damping * w[1],
            s * x[2] + spring.damping * w[2]};
  const Real rate = w[0] * x[0] + w[1] * x[1] + w[2] * x[2];
  const Real total = length == 0 ? 0 : s + spring.damping * rate / (length * length);
  return {total * x[0], total * x[1], total * x[2]};
}

/// The derivatives of the force on a by the position (N/m) and the velocity (N s/m) of b, 3 x 3 and
/// row-major:
///
///     k (1 - L/l) I + (k L/l) u u^T   and   d I,   or where the damping is axial
///     the former + d [ u (w - (w.u) u)^T + (w.u) (I - u u^T) ] / l   and   d u u^T.
template <class Real>
struct SpringDerivatives {
  std::array<Real, 9> by_position{}, by_velocity{};
};
template <class Real>
SpringDerivatives<Real> spring_derivatives(const Spring& spring, std::array<Real, 3> u,
                                           const std::array<Real, 3>& w) {
  SpringDerivatives<Real> result;
  const Real length = length_of(u);
  if (!spring.axial)
    for (const std::size_t i : {0U, 4U, 8U}) result.by_velocity[i] = spring.damping;
  if (length == 0) return result;
  for (Real& component : u) component /= length;
  const bool slack = spring.tension_only && length <= spring.rest_length;
  const Real across = elastic_factor(spring, length), along = slack ? 0 : spring.stiffness - across;
  const Real turning = spring.axial ? spring.damping / length : 0;
  const Real rate = w[0] * u[0] + w[1] * u[1] + w[2] * u[2];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Real identity = i == j ? 1 : 0;
      result.by_position[3 * i + j] =
          along * u[i] * u[j] + identity * across +
          turning * (rate * (identity - u[i] * u[j]) + u[i] * (w[j] - rate * u[j]));
      if (spring.axial) result.by_velocity[3 * i + j] = spring.damping * u[i] * u[j];
    }
  return result;
}

/// The elastic energy, J.
template <class Real>
Real spring_energy(const Spring& spring, const std::array<Real, 3>& x) {
  const Real stretch = length_of(x) - spring.rest_length;
  return stretch > 0 || !spring.tension_only ? spring.stiffness * stretch * stretch / 2 : 0;
}

/// Adds the forces of all springs, x y z of particle after particle. Springs of one first end that
/// follow each other are summed in registers.
template <class Real>
void add_spring_forces(const std::vector<Spring>& springs, const Real* q, const Real* v,
                       Real* force) {
  for (auto spring = springs.begin(); spring != springs.end();) {
    const std::size_t a = spring->a;
    std::array<Real, 3> sum{};
    for (; spring != springs.end() && spring->a == a; ++spring) {
      const std::size_t b = spring->b;
      const auto f =
          spring_force(*spring, difference(q + 3 * a, q + 3 * b), difference(v + 3 * a, v + 3 * b));
      for (std::size_t d = 0; d < 3; ++d) sum[d] += f[d], force[3 * b + d] -= f[d];
    }
    for (std::size_t d = 0; d < 3; ++d) force[3 * a + d] += sum[d];
  }
}

}  // namespace odeum::scene
