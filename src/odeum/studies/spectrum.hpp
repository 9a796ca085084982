// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::study {

/// The spectrum of the Jacobian along a solution (cases/spectrum.hpp), and the sizes of the
/// solution's components: at the start and at equal times, 32 of a small system and 8 of a large
/// one. The solution is by Radau IIA to 1e-8, or, of a large system that is not stiff, by Dormand's
/// and Prince's pair to 1e-6.
struct SpectrumAlong {
  std::string reason;         ///< why there is none; empty: there is
  std::vector<double> sizes;  ///< by component, the largest along the solution
  /// The eigenvalues in the left half plane, one of each conjugate pair: all, or the outermost of a
  /// large system.
  std::vector<std::complex<double>> eigenvalues;
  std::complex<double> largest;  ///< of all
  double growing = 0;            ///< the largest real part to the right of the axis; 0: none
};
SpectrumAlong spectrum_along(const Case& c, double time);

}  // namespace odeum::study
