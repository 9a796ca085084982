// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

namespace odeum::linear {

/// Lowest and highest eigenvalue of a symmetric tridiagonal matrix, by bisection with Sturm's
/// sequence (Golub and Van Loan, Matrix Computations, 8.4.1), to the last digits. `off` is one
/// shorter than `diagonal`, which is not empty.
std::pair<double, double> extreme_eigenvalues(const std::vector<double>& diagonal,
                                              const std::vector<double>& off);

}  // namespace odeum::linear
