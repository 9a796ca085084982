// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "odeum/problem/concepts.hpp"
#include "odeum/problem/shifted_solver.hpp"
#include "odeum/scene/model/scene.hpp"
#include "odeum/scene/springs/spring_grid.hpp"

namespace odeum::scene {

/// A scene of particles, springs and gravity as the problem
///
///     m_a x_a'' = sum over springs (a, b) of [ k (l - L) u + d (v_b - v_a) ] + m_a g,
///     l = |x_b - x_a|,  u = (x_b - x_a) / l;  fixed particles do not move.
///
/// The state is all positions x y z, then all velocities: 6 entries a particle. A spring of zero
/// length exerts no elastic force (its direction is undefined). Springs that form a regular grid
/// are computed by gathering (GridSprings), others edge by edge.
class MassSpring {
 public:
  static constexpr std::size_t dimension = dynamic;
  static constexpr bool velocity_dependent = true;

  /// Throws std::invalid_argument for a spring end that is no particle, a mass that is not positive
  /// on a free particle, a velocity on a fixed one, or a velocity_matrix, which is no term of this.
  explicit MassSpring(const Scene& scene);

  std::size_t size() const { return 6 * particles_; }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 3 * particles_, t, y, dydt);
  }
  void acceleration(double t, const double* q, const double* v, double* a) const;
  void jacobian_times(double t, const double* y, const double* x, double* product) const;
  /// Solves with a sparse symmetric matrix of 3 x 3 blocks.
  std::unique_ptr<ShiftedSolver> shifted_solver() const;
  /// Kinetic, elastic and gravitational, J.
  double energy(const double* y) const;

  const std::vector<Spring>& springs() const { return springs_; }
  const std::vector<double>& inverse_masses() const { return inverse_mass_; }  ///< 0: fixed
  std::size_t particles() const { return particles_; }
  /// The grid that was found in the scene; null where springs are computed edge by edge.
  const GridSprings<double>* grid() const { return grid_ ? &*grid_ : nullptr; }

 private:
  void edge_forces(const double* q, const double* v, double* force) const;
  void edge_derivative(const double* q, const double* dq, const double* dv, double* change) const;

  std::size_t particles_;
  std::vector<Spring> springs_;
  std::vector<double> mass_, inverse_mass_;
  Vec3 gravity_;
  std::optional<GridSprings<double>> grid_;
};

/// The 3 x 3 derivative of the elastic force on particle a with respect to the position of b:
/// k (u u^T + (1 - L/l) (I - u u^T)); zero for a slack tension-only spring. Row-major.
std::array<double, 9> spring_stiffness_block(const Spring& spring, const double* q);

}  // namespace odeum::scene
