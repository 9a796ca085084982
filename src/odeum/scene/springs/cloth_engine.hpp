// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "odeum/scene/springs/cloth_state.hpp"

namespace odeum::scene {

/// A cloth whose springs form a regular grid, stepped in the kernel's own layout from the first
/// step to the last, in double or single precision, on several threads: what a scene costs when
/// nothing but the scene is computed. Results are the same bits whatever the number of threads.
template <class Real>
class ClothEngine {
 public:
  /// Throws std::invalid_argument where the scene is no grid (find_grid), has a velocity_matrix, or
  /// `threads` is 0.
  explicit ClothEngine(const Scene& scene, std::size_t threads = 1);

  std::size_t particles() const { return state_.particles(); }
  std::size_t springs() const;

  /// `steps` steps of h seconds of velocity Verlet (methods/velocity_verlet.hpp): one evaluation of
  /// the forces a step, damping at the predicted velocity.
  void velocity_verlet(double h, std::size_t steps);
  /// The classical Runge-Kutta method (methods/rk4.hpp): four evaluations a step.
  void rk4(double h, std::size_t steps);

  /// All positions x y z (m), then all velocities (m/s): 6 numbers a particle.
  void read(double* y) const { state_.read(y); }

 private:
  ClothEngine(const Scene& scene, const GridStructure& grid, std::size_t threads);

  using Arrays = std::vector<Real>;  // three components of GridLayout

  /// Accelerations of one row, at positions q and velocities v.
  void accelerate(const Arrays& q, const Arrays& v, Arrays& a, std::size_t row) const;

  ClothState<Real> state_;
  GridSprings<Real> springs_;
  std::size_t threads_;
};

extern template class ClothEngine<double>;
extern template class ClothEngine<float>;

}  // namespace odeum::scene
