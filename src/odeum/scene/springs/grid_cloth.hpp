// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "odeum/core/team.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/problem/shifted_solver.hpp"
#include "odeum/scene/springs/spring_grid.hpp"

namespace odeum::scene {

/// A scene whose springs form a regular grid as a problem whose state has the layout of the vector
/// kernels: three components of GridLayout for the positions (m), then three for the velocities
/// (m/s), zero in the margins. In double or single precision, on one or several threads; results
/// are the same bits whatever their number.
template <class Real>
class GridCloth {
 public:
  using real = Real;
  static constexpr std::size_t dimension = dynamic;
  static constexpr bool velocity_dependent = true;

  /// Throws std::invalid_argument where require_grid does, or `threads` is 0.
  explicit GridCloth(const Scene& scene, std::size_t threads = 1);
  /// The grid is that of the scene's springs, or of those of them that are on a grid.
  GridCloth(const Scene& scene, const GridStructure& grid, std::size_t threads = 1);

  const GridLayout& layout() const { return springs_.layout(); }
  const GridSprings<Real>& springs() const { return springs_; }
  std::size_t particles() const { return layout().rows * layout().columns; }
  std::size_t size() const { return 6 * layout().size; }

  /// Moves all positions x y z, then all velocities, of particle after particle to a state in this
  /// layout, and back.
  std::vector<Real> scattered(const std::vector<double>& y) const;
  std::vector<double> gathered(const std::vector<Real>& state) const;

  void rhs(Real t, const Real* y, Real* dydt) const {
    second_order_rhs(*this, size() / 2, t, y, dydt);
  }
  /// v may be null: without the dampers.
  void acceleration(Real t, const Real* q, const Real* v, Real* a) const;
  void undamped_acceleration(Real t, const Real* q, Real* a) const {
    acceleration(t, q, nullptr, a);
  }
  /// See WithDamping. M v' = D v with a constant D, so that Chebyshev's iteration with Jacobi's
  /// preconditioner needs no inner product.
  std::uint64_t damp(Real t, const Real* q, Real h, Real* v, double relative) const;
  /// Null where a spring has a negative stiffness * rest_length.
  std::unique_ptr<ShiftedSolver> shifted_solver() const requires std::same_as<Real, double>;

 private:
  template <class Of>
  std::vector<Real> by_place(const Scene& scene, Of&& of) const;
  /// Calls update(i) for every place of a row in each of the three components.
  template <class Update>
  void each(std::size_t row, Update&& update) const;

  GridSprings<Real> springs_;
  std::vector<Real> mass_, inverse_mass_, gravity_;  // by place; zero where fixed, in the margins
  std::vector<Real> damping_;                        // by place: the sum over a particle's dampers
  std::unique_ptr<Team> team_;
};

extern template class GridCloth<double>;
extern template class GridCloth<float>;

}  // namespace odeum::scene
