// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "odeum/fem/elliptic.hpp"
#include "odeum/linear/generalized_modes.hpp"
#include "odeum/problem/shifted_solver.hpp"

namespace odeum::fem {

/// Mass by the vertex rule (lumped: diagonal), or exact (consistent).
enum class Mass { lumped, consistent };

/// Linear elements in space, time continuous: M u' = -K u + f (heat) or M u'' = -K u (wave), by the
/// unknowns of `assemble`, where u is 0 on the boundary.
struct SemiDiscrete {
  std::vector<Point> nodes;  ///< of the unknowns
  linear::SparseMatrix mass, stiffness;
  std::vector<double> load;
  /// -M^-1 K, dense by rows, and M^-1 f.
  std::vector<double> operator_matrix, source;

  std::size_t size() const { return load.size(); }
  /// M^-1 (-K u + f): by the sparse K where M is lumped, else by the dense operator.
  void rate(const double* u, double* dudt) const;
  std::shared_ptr<const linear::Modes> modes;  ///< of K phi = value M phi
  bool lumped = true;
};

/// For a few hundred unknowns. Throws as `assemble`.
SemiDiscrete semi_discrete(const TriangleMesh& mesh, const EllipticProblem& problem, Mass mass);

/// Solves (I - gamma h J) x = r for J = -M^-1 K as (M + gamma h K) x = M r (heat), and for J = [0,
/// I; -M^-1 K, 0] by the same with gamma^2 h^2 (wave), both by a sparse LDL^T. `system` must
/// outlive it.
std::unique_ptr<ShiftedSolver> heat_solver(const SemiDiscrete& system);
std::unique_ptr<ShiftedSolver> wave_solver(const SemiDiscrete& system);

}  // namespace odeum::fem
