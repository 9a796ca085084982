// SPDX-License-Identifier: BSD-3-Clause
// The only unit that includes Eigen's eigenvalue solvers, which compile slowly.
#include "odeum/linear/eigenvalues.hpp"

#include <Eigen/Eigenvalues>
#include <stdexcept>

namespace odeum {
namespace {

Eigen::EigenSolver<Eigen::MatrixXd> solved(const Eigen::MatrixXd& matrix, bool vectors) {
  Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix, vectors);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of a matrix did not converge");
  return solver;
}

auto by_columns(const std::vector<double>& matrix, std::size_t n) {
  const auto size = static_cast<Eigen::Index>(n);
  return Eigen::Map<const Eigen::MatrixXd>(matrix.data(), size, size);
}

}  // namespace

std::vector<std::complex<double>> eigenvalues(const std::vector<double>& matrix, std::size_t n) {
  const auto solver = solved(by_columns(matrix, n), false);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

std::vector<Eigenpair> eigenpairs(const std::vector<double>& matrix, std::size_t n) {
  const auto solver = solved(by_columns(matrix, n).transpose(), true);
  std::vector<Eigenpair> pairs(n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    pairs[k].value = solver.eigenvalues()[at];
    const Eigen::VectorXd sizes = solver.eigenvectors().col(at).cwiseAbs();
    pairs[k].sizes.assign(sizes.begin(), sizes.end());
  }
  return pairs;
}

}  // namespace odeum
