// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "odeum/linear/linear_peer.hpp"
#include "odeum/linear/sparse_matrix.hpp"

/// Eigen's solvers of a symmetric positive definite sparse system, as a direct solver where an own
/// method needs one and as peers of the own iterations.
namespace odeum::linear {

/// Eigen::SimplicialLDLT with its default ordering, approximate minimum degree.
class SparseLdlt {
 public:
  /// Throws std::invalid_argument where a pivot is not positive: A is singular or indefinite.
  explicit SparseLdlt(const SparseMatrix& a);
  ~SparseLdlt();
  SparseLdlt(SparseLdlt&&) noexcept;
  void solve(const double* b, double* x) const;
  /// Multiplications of one factorisation, and of one solution with its factors.
  double multiplications_to_factorise() const;
  double multiplications_to_solve() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// eigen/cg_ic_amd and eigen/cg_ic_natural, Eigen::ConjugateGradient with Eigen::IncompleteCholesky
/// in its default ordering and in the natural one, and eigen/simplicial_ldlt.
void add_eigen_peers(std::vector<LinearPeerInfo>& peers);

}  // namespace odeum::linear
