// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

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

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// Eigen::ConjugateGradient with Eigen::IncompleteCholesky; `ordering`: "amd" (its default) or
/// "natural".
class EigenConjugateGradients {
 public:
  /// Throws std::invalid_argument where the incomplete factorisation fails.
  EigenConjugateGradients(const SparseMatrix& a, const std::string& ordering);
  ~EigenConjugateGradients();
  /// Solves from a guess of 0 to |b - A x| <= tolerance |b|; how many iterations were done.
  int solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
            int most_iterations);

 private:
  struct Solver;
  template <class Ordering>
  struct SolverWith;
  std::unique_ptr<Solver> solver_;
};

}  // namespace odeum::linear
