// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "odeum/core/team.hpp"
#include "odeum/linear/eigen_solvers.hpp"
#include "odeum/linear/preconditioners.hpp"

namespace odeum::linear {

/// A V-cycle of geometric multigrid (Briggs, Henson and McCormick, A Multigrid Tutorial, chapter
/// 3): one forward sweep of Gauss-Seidel before and one backward after the correction from the
/// coarser grid, whose operator is P^T A P; LDL^T on the coarsest. The cycle is symmetric and
/// positive definite, so that it serves conjugate gradients too. Rows are swept in blocks of 16384,
/// each with what the others had before the sweep, so that threads share a sweep and the result is
/// the same bits whatever their number; in one block where that might not be positive definite.
class Multigrid final : public Preconditioner {
 public:
  /// `prolongations` from the next coarser grid to each grid, the finest first; with none it is a
  /// direct solver. `finest` must outlive the object. Throws std::invalid_argument where a matrix
  /// is not positive definite, or sizes do not fit.
  Multigrid(const SparseMatrix& finest, std::vector<SparseMatrix> prolongations,
            std::size_t threads = 1);

  void apply(const double* r, double* z) const override;
  std::size_t levels() const { return prolongations_.size() + 1; }

 private:
  const SparseMatrix& matrix(std::size_t level) const {
    return level == 0 ? finest_ : coarser_[level - 1];
  }
  void cycle(std::size_t level, const double* r, double* z) const;
  /// z = 0, then a sweep in rising order.
  void sweep_forward(std::size_t level, const double* r, double* z) const;
  void sweep_backward(std::size_t level, const double* r, double* z) const;
  template <class Work>
  void each_block(std::size_t level, Work&& work) const;

  const SparseMatrix& finest_;
  std::vector<SparseMatrix> prolongations_, restrictions_, coarser_;
  std::vector<std::vector<double>> inverses_;  ///< of the diagonal entries
  std::vector<int> block_;                     ///< by level: rows of a block
  SparseLdlt coarsest_;
  std::unique_ptr<Team> team_;
  // Each level has its residual, and each coarser one its right-hand side and its correction.
  mutable std::vector<std::vector<double>> residual_, right_, correction_;
};

}  // namespace odeum::linear
