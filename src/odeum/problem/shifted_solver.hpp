// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace odeum {

/// A problem's own way to solve (I - gamma_h J(t, y)) x = r, behind function pointers. One object
/// belongs to one solve and keeps its factors between calls.
class ShiftedSolver {
 public:
  virtual ~ShiftedSolver() = default;
  /// Evaluates J at (t, y) and factorises; false where the matrix is singular or not finite.
  virtual bool factorise(double t, const double* y, double gamma_h) = 0;
  /// Overwrites x = r by the solution: the residual is at most `relative` times r for an iterative
  /// solver, of the size of rounding for a direct one.
  virtual bool solve(double* x, double relative) = 0;
  static constexpr double exact = 1e-12;  ///< for solutions without a later correction
  /// For methods that solve one system a step and whose order does not depend on J: from now on J
  /// may be replaced by one that keeps the matrix positive definite at any step, and each solution
  /// is the guess for the next. A direct solver does nothing.
  virtual void solve_once_a_step() {}
  /// From now on J is replaced by a bound of it, with which the matrix is positive definite and
  /// which no state exceeds as far as a step reaches, for steps towards a solution from afar.
  /// False: there is none, and J stays.
  virtual bool bound() { return false; }
  /// What factors and solves have cost so far, in products with a matrix of J's sparsity.
  virtual std::uint64_t products() const { return 0; }
};

}  // namespace odeum
