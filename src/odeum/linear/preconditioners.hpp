// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/linear/sparse_matrix.hpp"

/// Preconditioners M of a symmetric positive definite sparse matrix A (Saad, Iterative Methods for
/// Sparse Linear Systems, chapter 10). All are symmetric and positive definite, as conjugate
/// gradients need. They hold a reference to A, which must outlive them, and throw
/// std::invalid_argument where a diagonal entry of A is not positive.
namespace odeum::linear {

class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// z = M^-1 r, arrays of as many doubles as A has rows.
  virtual void apply(const double* r, double* z) const = 0;
};

/// M = I.
class NoPreconditioner final : public Preconditioner {
 public:
  explicit NoPreconditioner(const SparseMatrix& a) : n_(a.rows) {}
  void apply(const double* r, double* z) const override;

 private:
  int n_;
};

/// M = D, the diagonal of A.
class JacobiPreconditioner final : public Preconditioner {
 public:
  explicit JacobiPreconditioner(const SparseMatrix& a);
  void apply(const double* r, double* z) const override;

 private:
  std::vector<double> inverse_;
};

/// M = w / (2 - w) (D / w + L) D^-1 (D / w + L^T), symmetric successive overrelaxation, 0 < w < 2;
/// w = 1: symmetric Gauss-Seidel.
class SsorPreconditioner final : public Preconditioner {
 public:
  explicit SsorPreconditioner(const SparseMatrix& a, double relaxation = 1);
  void apply(const double* r, double* z) const override;

 private:
  const SparseMatrix& a_;
  double relaxation_;
  std::vector<double> inverse_;
};

/// M = L L^T with the entries of the lower triangle of A (IC(0), Meijerink and van der Vorst 1977).
/// Where a pivot is not positive, A is replaced by A + shift D (Manteuffel 1980), with the shift
/// doubled until all are.
class IncompleteCholesky final : public Preconditioner {
 public:
  explicit IncompleteCholesky(const SparseMatrix& a);
  void apply(const double* r, double* z) const override;
  /// 0 where none was needed.
  double shift() const { return shift_; }

 private:
  bool factorise(const SparseMatrix& a);
  double shift_ = 0;
  SparseMatrix lower_;  ///< rows end with the inverse of the diagonal entry
};

}  // namespace odeum::linear
