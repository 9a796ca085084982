// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/linear/sparse_matrix.hpp"

namespace odeum::linear {

/// The solutions of K phi = value M phi in extended precision, by rising value; the vectors are
/// orthonormal in M.
struct Modes {
  std::vector<long double> values;
  std::vector<std::vector<long double>> vectors;

  /// phi^T v for each mode: coordinates of M^-1 v.
  std::vector<long double> coordinates(const std::vector<long double>& v) const;
};
/// Dense: for a few hundred unknowns. K symmetric, M symmetric positive definite. Throws
/// std::invalid_argument where M is not.
Modes generalized_modes(const SparseMatrix& k, const SparseMatrix& m);

}  // namespace odeum::linear
