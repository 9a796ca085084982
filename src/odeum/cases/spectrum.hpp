// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// Eigenvalues of a case's Jacobian at its start or at its horizon, where the truth knows that
/// state: at that of the two where the largest is larger, since a stiff problem may begin with
/// little stiffness. All of them where it has few unknowns, else the outermost, as Arnoldi's method
/// finds them (W. E. Arnoldi, Quart. Appl. Math. 9 (1951) 17-29). Products with the Jacobian are
/// differences of the right-hand side where the case offers no Jacobian. Conjugates are left out:
/// imaginary parts are not negative. In 1 / (unit of t).
struct Spectrum {
  std::vector<std::complex<double>> eigenvalues;
  double time = 0;  ///< when
};
Spectrum spectrum_of(const Case& c);

/// The same at any state.
std::vector<std::complex<double>> outermost_eigenvalues(const Case& c, double t,
                                                        const std::vector<double>& y);

}  // namespace odeum::cases
