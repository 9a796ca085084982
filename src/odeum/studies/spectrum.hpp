// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::study {

/// The eigenvalues of a problem's Jacobian at a state, per unit of time, in no particular order.
/// Throws std::invalid_argument where the problem offers no Jacobian, std::runtime_error where the
/// iteration for them does not converge.
std::vector<std::complex<double>> spectrum(const OdeView& view, double t, const double* y);

/// The spectrum along a solution, and the sizes of its components: at the start and at 32 equal
/// times, from a solution by Radau IIA to 1e-8.
struct SpectrumAlong {
  std::string reason;         ///< why there is none; empty: there is
  std::vector<double> sizes;  ///< by component, the largest along the solution
  /// All that lie in the left half plane, one of each conjugate pair.
  std::vector<std::complex<double>> eigenvalues;
  std::complex<double> largest;  ///< of all
};
SpectrumAlong spectrum_along(const Case& c, double time);

}  // namespace odeum::study
