// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/model/mass_spring.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace odeum::scene {

MassSpring::MassSpring(const Scene& scene)
    : particles_(scene.size()), springs_(scene.springs), gravity_(scene.gravity) {
  if (scene.velocity_matrix != std::array<double, 9>{})
    throw std::invalid_argument("a mass-spring system has no medium (velocity_matrix)");
  for (const Particle& particle : scene.particles) {
    if (!particle.fixed && !(particle.mass > 0))
      throw std::invalid_argument("a free particle needs a positive mass");
    if (particle.fixed && particle.velocity != Vec3{})
      throw std::invalid_argument("a fixed particle has no velocity");
    mass_.push_back(particle.mass);
    inverse_mass_.push_back(particle.fixed ? 0 : 1 / particle.mass);
  }
  std::stable_sort(springs_.begin(), springs_.end(),
                   [](const Spring& l, const Spring& r) { return l.a < r.a; });
  for (const Spring& spring : springs_)
    if (spring.a >= particles_ || spring.b >= particles_ || spring.a == spring.b)
      throw std::invalid_argument("spring between particles " + std::to_string(spring.a) + " and " +
                                  std::to_string(spring.b) + " of " + std::to_string(particles_));
  if (const auto structure = find_grid(scene))
    grid_.emplace(GridLayout(structure->rows, structure->columns), structure->kinds);
}

// Springs are sorted by their first end, whose force is summed up in registers.
void MassSpring::edge_forces(const double* q, const double* v, double* force) const {
  for (std::size_t i = 0; i < 3 * particles_; ++i) force[i] = 0;
  for (auto spring = springs_.begin(); spring != springs_.end();) {
    const std::size_t first = spring->a;
    const double *qa = q + 3 * first, *va = v + 3 * first;
    double fx = 0, fy = 0, fz = 0;
    for (; spring != springs_.end() && spring->a == first; ++spring) {
      const double *qb = q + 3 * spring->b, *vb = v + 3 * spring->b;
      double* const fb = force + 3 * spring->b;
      const double x = qb[0] - qa[0], y = qb[1] - qa[1], z = qb[2] - qa[2];
      const double length = std::sqrt(x * x + y * y + z * z);
      const bool slack = (spring->tension_only && length <= spring->rest_length) || length == 0;
      const double s = slack ? 0 : spring->stiffness * (1 - spring->rest_length / length);
      const double gx = s * x + spring->damping * (vb[0] - va[0]);
      const double gy = s * y + spring->damping * (vb[1] - va[1]);
      const double gz = s * z + spring->damping * (vb[2] - va[2]);
      fx += gx, fy += gy, fz += gz;
      fb[0] -= gx, fb[1] -= gy, fb[2] -= gz;
    }
    double* const fa = force + 3 * first;
    fa[0] += fx, fa[1] += fy, fa[2] += fz;
  }
}

namespace {

/// Work space of the grid kernel: each thread its own, since threads share the problem.
double* scratch(std::size_t size) {
  thread_local std::vector<double> space;
  if (space.size() < size) space.resize(size);
  return space.data();
}

}  // namespace

void MassSpring::acceleration(double, const double* q, const double* v, double* a) const {
  if (grid_) {
    const GridLayout& layout = grid_->layout();
    const std::size_t n = 3 * layout.size;
    double *const gq = scratch(3 * n), *const gv = gq + n, *const force = gv + n;
    layout.scatter(q, gq);
    layout.scatter(v, gv);
    grid_->forces(gq, gv, force, 0, layout.rows);
    layout.gather(force, a);
  } else {
    edge_forces(q, v, a);
  }
  for (std::size_t i = 0; i < particles_; ++i) {
    const double free = inverse_mass_[i] != 0 ? 1 : 0;
    for (std::size_t d = 0; d < 3; ++d)
      a[3 * i + d] = a[3 * i + d] * inverse_mass_[i] + free * gravity_[d];
  }
}

std::array<double, 9> spring_stiffness_block(const Spring& spring, const double* q) {
  const double *qa = q + 3 * spring.a, *qb = q + 3 * spring.b;
  double u[3];
  for (int d = 0; d < 3; ++d) u[d] = qb[d] - qa[d];
  const double length = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  std::array<double, 9> block{};
  if (length == 0 || (spring.tension_only && length <= spring.rest_length)) return block;
  for (double& component : u) component /= length;
  const double across = spring.stiffness * (1 - spring.rest_length / length);
  const double along = spring.stiffness - across;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) block[3 * i + j] = along * u[i] * u[j] + (i == j ? across : 0);
  return block;
}

// The derivative of a spring's force is k (u u^T + (1 - L/l) (I - u u^T)) applied to the difference
// of the ends, as in spring_stiffness_block, here without the matrix.
void MassSpring::edge_derivative(const double* q, const double* dq, const double* dv,
                                 double* change) const {
  for (std::size_t i = 0; i < 3 * particles_; ++i) change[i] = 0;
  for (const Spring& spring : springs_) {
    const std::size_t a = 3 * spring.a, b = 3 * spring.b;
    const double u[3] = {q[b] - q[a], q[b + 1] - q[a + 1], q[b + 2] - q[a + 2]};
    const double d[3] = {dq[b] - dq[a], dq[b + 1] - dq[a + 1], dq[b + 2] - dq[a + 2]};
    const double squared = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    const double length = std::sqrt(squared);
    const bool slack = (spring.tension_only && length <= spring.rest_length) || length == 0;
    const double across = slack ? 0 : spring.stiffness * (1 - spring.rest_length / length);
    const double along =
        slack ? 0
              : (spring.stiffness - across) / squared * (u[0] * d[0] + u[1] * d[1] + u[2] * d[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const double f = across * d[i] + along * u[i] + spring.damping * (dv[b + i] - dv[a + i]);
      change[a + i] += f;
      change[b + i] -= f;
    }
  }
}

void MassSpring::jacobian_times(double, const double* y, const double* x, double* product) const {
  const std::size_t n = 3 * particles_;
  const double *dq = x, *dv = x + n;
  double* const da = product + n;
  std::copy_n(dv, n, product);
  if (grid_) {
    const GridLayout& layout = grid_->layout();
    const std::size_t size = 3 * layout.size;
    double *const gq = scratch(4 * size), *const gdq = gq + size, *const gdv = gdq + size,
                  *const change = gdv + size;
    layout.scatter(y, gq);
    layout.scatter(dq, gdq);
    layout.scatter(dv, gdv);
    grid_->derivative(gq, gdq, gdv, change, 0, layout.rows);
    layout.gather(change, da);
  } else {
    edge_derivative(y, dq, dv, da);
  }
  for (std::size_t i = 0; i < n; ++i) da[i] *= inverse_mass_[i / 3];
}

double MassSpring::energy(const double* y) const {
  const double *q = y, *v = y + 3 * particles_;
  double sum = 0;
  for (std::size_t i = 0; i < particles_; ++i) {
    if (inverse_mass_[i] == 0) continue;
    for (std::size_t d = 0; d < 3; ++d)
      sum += mass_[i] * (v[3 * i + d] * v[3 * i + d] / 2 - gravity_[d] * q[3 * i + d]);
  }
  for (const Spring& spring : springs_) {
    double squared = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double difference = q[3 * spring.b + d] - q[3 * spring.a + d];
      squared += difference * difference;
    }
    const double stretch = std::sqrt(squared) - spring.rest_length;
    if (stretch > 0 || !spring.tension_only) sum += spring.stiffness * stretch * stretch / 2;
  }
  return sum;
}

}  // namespace odeum::scene
