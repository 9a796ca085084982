// SPDX-License-Identifier: BSD-3-Clause
// Writes cloth11_two_way_long.csv: the cloth of cases/cloth.cpp (k = 10) at t = 0.25, 0.5, 1 and 2.
//
// The index states 12 digits for cloth11_two_way.csv: errors of high-order methods fall below them
// before their slopes settle. This is the same cloth in 113 bits, its data rounded to double as in
// a scene: Gragg's extrapolation of order 16 with 640 steps per second, independent of Odeum's
// code. With 480 steps per second it differs by 1e-20; cloth11_two_way.csv agrees to 3e-15 in the
// positions. Data that are not rounded change them by 4e-17 (root mean square), the effect of
// rounding in a spring's length. It takes a minute and is not part of the build:
//     g++ -std=gnu++20 -O3 cloth11_two_way_long.cpp -lquadmath && ./a.out >
//     cloth11_two_way_long.csv
#include <quadmath.h>

#include <cstdio>
#include <cstdlib>

#include "cloth11_long.hpp"

using Real = __float128;

Real stretch(Real squared, Real rest) { return 1 - rest / sqrtq(squared); }

int main(int argc, char** argv) {
  const int steps_a_quarter = argc > 1 ? std::atoi(argv[1]) : 160;
  State<Real> y = initial<Real>();
  std::puts("t,component,value");
  for (int quarter = 1; quarter <= 8; ++quarter) {
    for (int step = 0; step < steps_a_quarter; ++step)
      y = advanced<8>(y, Real(0.25) / steps_a_quarter, stretch);
    if ((quarter & (quarter - 1)) != 0) continue;
    for (std::size_t i = 0; i < y.size(); ++i) {
      std::array<char, 64> digits;
      quadmath_snprintf(digits.data(), digits.size(), "%.20Qg", y[i]);
      std::printf("%g,%zu,%s\n", quarter / 4.0, i, digits.data());
    }
  }
}
