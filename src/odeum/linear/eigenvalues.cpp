// SPDX-License-Identifier: BSD-3-Clause
// The only unit that includes Eigen's eigenvalue solvers, which compile slowly.
#include "odeum/linear/eigenvalues.hpp"

#include <Eigen/Eigenvalues>
#include <stdexcept>

namespace odeum {

std::vector<std::complex<double>> eigenvalues(const std::vector<double>& matrix, std::size_t n) {
  const auto size = static_cast<Eigen::Index>(n);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(
      Eigen::Map<const Eigen::MatrixXd>(matrix.data(), size, size), false);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of a matrix did not converge");
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

}  // namespace odeum
