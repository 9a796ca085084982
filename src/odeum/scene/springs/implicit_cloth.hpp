// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/scene/springs/cloth_state.hpp"
#include "odeum/scene/springs/grid_matrix.hpp"

namespace odeum::scene {

/// A cloth whose springs form a regular grid, stepped by one Newton step of backward Euler,
///
///     (M - h D - h^2 K) dv = h F(q + h v, v),   v += dv,   q += h v,
///
/// with the derivatives K and D of the forces F taken at q + h v, where the step would end without
/// forces: the error is up to five times smaller than with those at q (implicit_euler_linearised),
/// and a product with K is spared. K is clamped to be semidefinite, so that the matrix is positive
/// definite at any step. Order 1, stable at steps at which explicit methods are not.
class ImplicitCloth {
 public:
  /// Throws std::invalid_argument where the scene is no grid (find_grid), has a velocity_matrix, or
  /// a spring of negative stiffness * rest_length.
  explicit ImplicitCloth(const Scene& scene);

  /// `steps` steps of h seconds; the residual of each linear system falls to `relative` of its
  /// right side. False where conjugate gradients do not end.
  bool step(double h, std::size_t steps, double relative);
  /// All positions x y z (m), then all velocities (m/s): 6 numbers a particle.
  void read(double* y) const { state_.read(y); }
  /// Products with the matrix so far.
  std::uint64_t products() const { return matrix_.products(); }

 private:
  using Arrays = std::vector<double>;  // three components of GridLayout

  ImplicitCloth(const Scene& scene, const GridStructure& grid);

  ClothState<double> state_;
  GridSprings<double> springs_;
  GridMatrix matrix_;
};

}  // namespace odeum::scene
