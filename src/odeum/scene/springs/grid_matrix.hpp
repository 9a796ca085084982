// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "odeum/linear/conjugate_gradients.hpp"
#include "odeum/problem/shifted_solver.hpp"
#include "odeum/scene/springs/spring_grid.hpp"
#include "odeum/scene/surface/surface_stiffness.hpp"

namespace odeum::scene {

/// The matrix of an implicit step of springs on a grid,
///
///     A = M - g D - g^2 K,
///
/// with M the masses, K and D the derivatives of the springs' forces by positions and velocities;
/// symmetric, and positive definite unless compressed springs outweigh the masses. Surfaces that
/// meet have their share of K. All vectors have the grid's layout, three components one after the
/// other, with zeros in the margins.
class GridMatrix {
 public:
  /// `mass` by place (kg), 0 where a particle is fixed and in the margins. The springs must outlive
  /// the matrix, and have no negative stiffness * rest_length.
  GridMatrix(const GridSprings<double>& springs, const double* mass,
             const Surfaces* surfaces = nullptr);

  /// Takes the springs as they are at q; `clamped` as GridSprings::stiffness has it: A is positive
  /// definite then, whatever the springs.
  void assemble(const double* q, double g, bool clamped = false);
  /// product = g K x on free particles, 0 on fixed ones. After an assemble() with g != 0.
  void stiffness_times(const double* x, double* product) const;
  /// product = A x on free particles, 0 on fixed ones.
  void multiply(const double* x, double* product) const;
  /// A x = b on free particles, by conjugate gradients with the inverses of A's diagonal blocks. On
  /// entry x is the guess on free particles, and the known value on fixed ones; b is zero there.
  /// False where A is found indefinite.
  bool solve(const double* b, double* x, double relative_tolerance);
  /// Products with A that all solves took so far.
  std::uint64_t products() const { return cg_.products(); }

  /// M x, 0 on fixed particles.
  void mass_times(const double* x, double* product) const;
  /// Sets x to zero on free particles.
  void clear_free(double* x) const;

 private:
  /// The springs of one kind, each at the index of its end a. A spring adds (c I + s s^T) times the
  /// difference of its ends to A, and the same with another c to -g^2 K.
  struct Kind {
    std::size_t offset = 0;          // of b
    std::vector<double> damping;     // 0 where there is no spring
    std::vector<double> stiffness;   // c of -g^2 K
    std::vector<double> components;  // c of A, then the three of s
  };
  template <bool whole>
  void spring_times(const double* x, double* product) const;
  /// product += factor times the share of the surfaces in K x on free particles.
  void add_surfaces(const double* x, double factor, double* product) const;
  void invert_diagonal();
  void precondition(const double* r, double* z) const;

  const GridSprings<double>& springs_;
  GridLayout layout_;
  std::vector<double> mass_, free_;  // by place; 1 where a particle is free
  std::vector<Kind> kinds_;
  std::vector<double> inverse_[6];  // of the diagonal blocks: xx, xy, xz, yy, yz, zz
  linear::ConjugateGradients cg_;
  double g_ = 0;
  std::optional<SurfaceStiffness> surfaces_;
  mutable Quads x_, sum_;  ///< by particle
};

/// Solves (I - g J) x = r of springs on a grid for states in the grid's layout, positions before
/// velocities: x_q = r_q + g x_v and A x_v = M r_v + g K r_q by conjugate gradients. A solve fails,
/// with x lost, where A is found indefinite, which solve_once_a_step() excludes.
class GridShiftedSolver final : public ShiftedSolver {
 public:
  GridShiftedSolver(const GridSprings<double>& springs, const double* mass,
                    const Surfaces* surfaces = nullptr);
  bool factorise(double t, const double* y, double gamma_h) override;
  bool solve(double* x, double relative) override;
  void solve_once_a_step() override { once_ = true; }
  std::uint64_t products() const override { return matrix_.products(); }

 private:
  GridMatrix matrix_;
  std::size_t n_;                               // of positions
  std::vector<double> right_, scratch_, last_;  // the last x_v on free particles
  double g_ = 0;
  bool once_ = false;
};

}  // namespace odeum::scene
