// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <complex>
#include <cstddef>

/// Extrapolation of Gragg's modified midpoint rule (Hairer, Norsett, Wanner, Solving ODEs I, II.9):
/// its sequence of substeps, weights, and stability function.
namespace odeum {

/// Substeps of line j (from 0): 2, 4, 6, ...; the harmonic sequence doubled.
constexpr int extrapolation_substeps(int line) { return 2 * (line + 1); }

/// The weight w of the extrapolation table, T_{j,k} = T_{j,k-1} + w (T_{j,k-1} - T_{j-1,k-1}): 1
/// over (n_j / n_{j-k})^2 - 1.
constexpr double extrapolation_weight(int line, int column) {
  const double ratio =
      static_cast<double>(extrapolation_substeps(line)) / extrapolation_substeps(line - column);
  return 1 / (ratio * ratio - 1);
}

/// The stability function of the last entry of line `lines - 1`.
template <int Lines>
std::complex<double> extrapolated_midpoint_stability(std::complex<double> z) {
  std::array<std::complex<double>, Lines> table{};
  for (int line = 0; line < Lines; ++line) {
    const int n = extrapolation_substeps(line);
    const std::complex<double> hz = z / static_cast<double>(n);
    std::complex<double> before = 1, now = 1.0 + hz;
    for (int k = 1; k < n; ++k) {
      const std::complex<double> next = before + 2.0 * hz * now;
      before = now;
      now = next;
    }
    now = (before + now + hz * now) / 2.0;
    for (int k = 0; k < line; ++k) {
      const std::complex<double> above = table[static_cast<std::size_t>(k)];
      table[static_cast<std::size_t>(k)] = now;
      now += extrapolation_weight(line, k + 1) * (now - above);
    }
    table[static_cast<std::size_t>(line)] = now;
  }
  return table[Lines - 1];
}

}  // namespace odeum
