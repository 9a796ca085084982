// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/study/spectrum.hpp"

#include <Eigen/Dense>
#include <stdexcept>

namespace odeum::study {

std::vector<std::complex<double>> spectrum(const OdeView& view, double t, const double* y) {
  if (!view.jacobian) throw std::invalid_argument("spectrum: the problem offers no Jacobian");
  const auto n = static_cast<Eigen::Index>(view.dimension);
  Eigen::MatrixXd jacobian(n, n);
  // Row-major in a column-major matrix: transposed, which changes no eigenvalue.
  view.jacobian(view.problem, t, y, jacobian.data());
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(jacobian, false);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("spectrum: the eigenvalues did not converge");
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

}  // namespace odeum::study
