// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "odeum/scene/springs/cloth_state.hpp"

namespace odeum::scene {

/// The largest stable steps on cloths with springs to all neighbours one and two away, measured: of
/// the springs times sqrt(m/k), and of velocity Verlet with their dampers times m/d.
inline constexpr double spring_limit = 0.566, verlet_damping_limit = 0.046;

/// A cloth whose springs form a regular grid, its elasticity explicit and its damping implicit: a
/// Strang splitting of velocity Verlet for the springs and gravity, and the trapezoidal rule
///
///     (M - h/2 D) v' = (M + h/2 D) v
///
/// for the dampers. D is constant, so that Chebyshev's iteration with Jacobi's preconditioner needs
/// no inner product, and as many rounds at every step. Order 2. Damping limits the step no longer,
/// which for a fine cloth it else does: what limits this one is `spring_limit`.
template <class Real>
class ImexCloth {
 public:
  /// Throws std::invalid_argument where the scene is no grid (find_grid), has a velocity_matrix, or
  /// `threads` is 0.
  explicit ImexCloth(const Scene& scene, std::size_t threads = 1);

  /// `steps` steps of h seconds; the error of each damping step falls to `relative` of it.
  void step(double h, std::size_t steps, double relative);
  /// All positions x y z (m), then all velocities (m/s): 6 numbers a particle.
  void read(double* y) const { state_.read(y); }

 private:
  using Arrays = std::vector<Real>;  // three components of GridLayout

  ImexCloth(const Scene& scene, const GridStructure& grid, std::size_t threads);

  /// Of the damping step's matrix over its diagonal.
  double lowest_eigenvalue(double step) const;

  ClothState<Real> state_;
  GridSprings<Real> springs_;  // elastic, without dampers
  GridSprings<Real> dampers_;  // all of it, for its dampers
  std::size_t threads_ = 1;
  Arrays damping_;  // of each particle, the sum over its dampers; by place
};

extern template class ImexCloth<double>;
extern template class ImexCloth<float>;

}  // namespace odeum::scene
