// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace odeum::cases {

/// The solution of z' = M z from z0 at s = 0 as expressions in `time`, one for each of the first
/// `shown` components: sums of s^k e^(l s) over the eigenvalues l of M, which may be multiple, with
/// the coefficients that give the derivatives at 0. Eigenvalues that differ by rounding are taken
/// as one. `m` is dense, by rows. Empty where no such sum agrees with the matrix exponential to
/// 1e-9 of the state's size at times up to `end`.
std::vector<std::string> modal_solution(const std::vector<double>& m, const std::vector<double>& z0,
                                        std::size_t shown, double end, const std::string& time);

}  // namespace odeum::cases
