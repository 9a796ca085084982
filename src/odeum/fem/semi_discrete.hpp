// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "odeum/fem/elliptic.hpp"
#include "odeum/linear/generalized_modes.hpp"
#include "odeum/problem/shifted_solver.hpp"
#include "odeum/problem/sparsity.hpp"

namespace odeum::fem {

/// Mass by the vertex rule (lumped: diagonal), or exact (consistent).
enum class Mass { lumped, consistent };

/// Linear elements in space, time continuous: M u' = -K u + f (heat) or M u'' = -K u (wave), by the
/// unknowns of `assemble`, where u is 0 on the boundary.
struct SemiDiscrete {
  std::vector<Point> nodes;  ///< of the unknowns
  linear::SparseMatrix mass, stiffness;
  std::vector<double> load;
  std::vector<double> source;  ///< M^-1 f
  /// -M^-1 K: where M is lumped its entries by a pattern, which is that of K, else dense by rows.
  Sparsity pattern;
  std::vector<double> entries, operator_matrix;

  std::size_t size() const { return load.size(); }
  /// M^-1 (-K u + f): by the sparse K where M is lumped, else by the dense operator.
  void rate(const double* u, double* dudt) const;
  std::shared_ptr<const linear::Modes> modes;  ///< of K phi = value M phi; null: not asked for
  bool lumped = true;
  /// Where it is set: the multiplications of all products with K, factorisations and solutions so
  /// far. Not for several threads.
  std::shared_ptr<double> multiplications;
};

/// With modes, or with a consistent mass, for a few hundred unknowns: dense matrices. Throws as
/// `assemble`.
SemiDiscrete semi_discrete(const TriangleMesh& mesh, const EllipticProblem& problem, Mass mass,
                           bool with_modes = true);

/// Solves (I - gamma h J) x = r for J = -M^-1 K as (M + gamma h K) x = M r (heat), and for J = [0,
/// I; -M^-1 K, 0] by the same with gamma^2 h^2 (wave), both by a sparse LDL^T, which is kept as
/// long as gamma h is the same. `system` must outlive it.
std::unique_ptr<ShiftedSolver> heat_solver(const SemiDiscrete& system);
std::unique_ptr<ShiftedSolver> wave_solver(const SemiDiscrete& system);

}  // namespace odeum::fem
