// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <vector>

#include "odeum/problem/ode_view.hpp"

namespace odeum::study {

/// The eigenvalues of a problem's Jacobian at a state, per unit of time, in no particular order.
/// Throws std::invalid_argument where the problem offers no Jacobian, std::runtime_error where the
/// iteration for them does not converge.
std::vector<std::complex<double>> spectrum(const OdeView& view, double t, const double* y);

}  // namespace odeum::study
