// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

/// The numerical differentiation formulas (Shampine, Reichelt, The MATLAB ODE suite, SIAM J. Sci.
/// Comput. 18 (1997) 1-22, table 1).
namespace odeum::ndf {

inline constexpr int max_order = 5;

/// kappa_k of order k; at 0 the formula is the BDF.
inline constexpr std::array<double, max_order + 1> kappa{0, -0.1850, -1. / 9, -0.0823, -0.0415, 0};

/// gamma_k = 1 + 1/2 + ... + 1/k.
inline constexpr std::array<double, max_order + 1> gamma = [] {
  std::array<double, max_order + 1> g{};
  for (std::size_t k = 1; k <= max_order; ++k) g[k] = g[k - 1] + 1 / static_cast<double>(k);
  return g;
}();

/// The local error of order k over the difference of order k + 1.
constexpr double error_constant(int k) {
  const auto i = static_cast<std::size_t>(k);
  return k == 0 ? 1 : kappa[i] * gamma[i] + 1 / static_cast<double>(k + 1);
}

}  // namespace odeum::ndf
