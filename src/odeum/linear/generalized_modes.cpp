// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/generalized_modes.hpp"

#include <Eigen/Eigenvalues>
#include <numeric>
#include <stdexcept>

#include "odeum/linear/sparse_eigen.hpp"

namespace odeum::linear {

std::vector<long double> Modes::coordinates(const std::vector<long double>& v) const {
  std::vector<long double> all;
  for (const auto& vector : vectors)
    all.push_back(std::inner_product(vector.begin(), vector.end(), v.begin(), 0.L));
  return all;
}

Modes generalized_modes(const SparseMatrix& k, const SparseMatrix& m) {
  using Dense = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const Dense mass = eigen_map(m).toDense().cast<long double>();
  if (Eigen::LLT<Dense>(mass).info() != Eigen::Success)
    throw std::invalid_argument("the mass matrix is not positive definite");
  const Eigen::GeneralizedSelfAdjointEigenSolver<Dense> solver(
      eigen_map(k).toDense().cast<long double>(), mass);
  Modes modes;
  for (Eigen::Index i = 0; i < solver.eigenvalues().size(); ++i) {
    modes.values.push_back(solver.eigenvalues()(i));
    const auto column = solver.eigenvectors().col(i);
    modes.vectors.emplace_back(column.begin(), column.end());
  }
  return modes;
}

}  // namespace odeum::linear
