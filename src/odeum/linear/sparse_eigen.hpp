// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Includes Eigen: for .cpp files alone.
#include <Eigen/SparseCore>

#include "odeum/linear/sparse_matrix.hpp"

namespace odeum::linear {

using EigenRows = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
using EigenColumns = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// The same arrays as Eigen's matrix; `a` must outlive it.
inline Eigen::Map<const EigenRows> eigen_map(const SparseMatrix& a) {
  return {a.rows,         a.columns,       static_cast<Eigen::Index>(a.value.size()),
          a.start.data(), a.column.data(), a.value.data()};
}

}  // namespace odeum::linear
