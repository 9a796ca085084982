// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

namespace odeum::linear {

/// e^A for a dense row-major n x n matrix (Higham, SIAM J. Matrix Anal. Appl. 26 (2005) 1179-1193).
/// Empty where an entry is not finite or overflows.
std::vector<double> matrix_exponential(const std::vector<double>& a, std::size_t n);

}  // namespace odeum::linear
