// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace odeum {
class Team;
}

namespace odeum::linear {

/// An entry to be added into a matrix.
struct Triplet {
  int row, column;
  double value;
};

/// A sparse matrix by rows: entries start[i] to start[i + 1] - 1 are those of row i, by rising
/// column. Has the layout of Eigen's compressed SparseMatrix<double, RowMajor, int>.
struct SparseMatrix {
  int rows = 0, columns = 0;
  std::vector<int> start{0}, column;
  std::vector<double> value;

  /// y = A x, arrays of `columns` and `rows` doubles; the threads of `team` take some rows each.
  void multiply(const double* x, double* y, Team* team = nullptr) const;
  /// An entry; 0 where none is stored.
  double at(int row, int col) const;
  /// The diagonal of a square matrix.
  std::vector<double> diagonal() const;
};

/// Entries of the same place are added up. Throws std::out_of_range for one outside of the matrix.
SparseMatrix from_triplets(int rows, int columns, const std::vector<Triplet>& triplets);

/// P^T A P, the operator of a coarser grid. Throws std::invalid_argument where sizes do not fit.
SparseMatrix galerkin_product(const SparseMatrix& a, const SparseMatrix& p);

/// |b - A x|, Euclidean.
double residual_norm(const SparseMatrix& a, const std::vector<double>& x,
                     const std::vector<double>& b);
/// sqrt(x^T A x), of a positive semidefinite A.
double energy_norm(const SparseMatrix& a, const std::vector<double>& x);

}  // namespace odeum::linear
