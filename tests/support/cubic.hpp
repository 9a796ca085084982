// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

namespace odeum::tests {

using State1 = std::array<double, 1>;

/// y = (t + 6) (t + 2) (t - 2)
struct Cubic {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double*, double* dydt) const { dydt[0] = 3 * t * t + 12 * t - 4; }
  static double at(double t) { return (t + 6) * (t + 2) * (t - 2); }
};

}  // namespace odeum::tests
