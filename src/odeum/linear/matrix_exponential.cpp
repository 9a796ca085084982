// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/matrix_exponential.hpp"

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

namespace odeum::linear {

std::vector<double> matrix_exponential(const std::vector<double>& a, std::size_t n) {
  const auto size = static_cast<Eigen::Index>(n);
  // Eigen reads by columns: the exponential of the transpose is the transpose of the exponential.
  const Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(a.data(), size, size);
  if (!matrix.allFinite()) return {};
  const Eigen::MatrixXd e = matrix.exp();
  if (!e.allFinite()) return {};
  return {e.data(), e.data() + e.size()};
}

}  // namespace odeum::linear
