// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, for odeint's rosenbrock4.
#include <cstddef>

namespace odeum::cases {

/// High irradiance response of a plant: eight reacting species.
struct Hires {
  static constexpr std::size_t dimension = 8;

  template <class R>
  void rhs(R, const R* y, R* f) const {
    const R bind = 280 * y[5] * y[7];
    f[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
    f[1] = 1.71 * y[0] - 8.75 * y[1];
    f[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
    f[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
    f[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
    f[5] = -bind + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
    f[6] = bind - 1.81 * y[6];
    f[7] = -f[6];
  }
  void jacobian(double, const double* y, double* j) const {
    const double b5 = 280 * y[7], b7 = 280 * y[5];
    const double rows[8][8] = {
        {-1.71, 0.43, 8.32, 0, 0, 0, 0, 0},   {1.71, -8.75, 0, 0, 0, 0, 0, 0},
        {0, 0, -10.03, 0.43, 0.035, 0, 0, 0}, {0, 8.32, 1.71, -1.12, 0, 0, 0, 0},
        {0, 0, 0, 0, -1.745, 0.43, 0.43, 0},  {0, 0, 0, 0.69, 1.71, -b5 - 0.43, 0.69, -b7},
        {0, 0, 0, 0, 0, b5, -1.81, b7},       {0, 0, 0, 0, 0, -b5, 1.81, -b7}};
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < 8; ++k) j[8 * i + k] = rows[i][k];
  }
};

}  // namespace odeum::cases
