// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/limits/spectrum.hpp"

#include <stdexcept>

#include "odeum/linear/eigenvalues.hpp"

namespace odeum::study {

std::vector<std::complex<double>> spectrum(const OdeView& view, double t, const double* y) {
  if (!view.jacobian) throw std::invalid_argument("spectrum: the problem offers no Jacobian");
  std::vector<double> jacobian(view.dimension * view.dimension);
  view.jacobian(view.problem, t, y, jacobian.data());
  return eigenvalues(jacobian, view.dimension);
}

}  // namespace odeum::study
