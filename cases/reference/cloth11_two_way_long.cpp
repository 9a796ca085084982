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

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using Real = __float128;
using State = std::vector<Real>;  // all positions, then all velocities

constexpr int n = 11, particles = n * n, half = 3 * particles;
constexpr double stiffness = 10, damping = 0.05, gravity = -9.8;
constexpr Real mass = 3. / particles;

double place(int i) { return static_cast<double>(i) / (n - 1); }

struct Spring {
  int a, b;
  Real rest;
};

std::vector<Spring> springs() {
  std::vector<Spring> all;
  constexpr std::array<std::array<int, 2>, 4> directions{{{0, 1}, {1, -1}, {1, 0}, {1, 1}}};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int reach = 1; reach <= 2; ++reach)
        for (const auto& [di, dj] : directions) {
          const int k = i + reach * di, l = j + reach * dj;
          if (k < n && l >= 0 && l < n)
            all.push_back(
                {i * n + j, k * n + l, std::hypot(place(k) - place(i), place(l) - place(j))});
        }
  return all;
}

State initial() {
  State y(2 * half);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      Real* const x = &y[3 * (i * n + j)];
      x[0] = place(i);
      x[1] = place(j);
      if (i >= 3 && i < n - 3 + 1 && j >= 3 && j < n - 3 + 1)
        for (int d = 0; d < 3; ++d) x[half + d] = 7.5;
    }
  return y;
}

void slope(const State& y, State& f) {
  static const std::vector<Spring> all = springs();
  for (int i = 0; i < half; ++i) {
    f[i] = y[half + i];
    f[half + i] = i % 3 == 1 ? mass * gravity : 0;
  }
  for (const Spring& s : all) {
    std::array<Real, 3> d, w;
    Real squared = 0;
    for (int k = 0; k < 3; ++k) {
      d[k] = y[3 * s.b + k] - y[3 * s.a + k];
      w[k] = y[half + 3 * s.b + k] - y[half + 3 * s.a + k];
      squared += d[k] * d[k];
    }
    const Real pull = stiffness * (1 - s.rest / sqrtq(squared));
    for (int k = 0; k < 3; ++k) {
      const Real force = pull * d[k] + damping * w[k];
      f[half + 3 * s.a + k] += force;
      f[half + 3 * s.b + k] -= force;
    }
  }
  for (int p = 0; p < particles; ++p)
    for (int k = 0; k < 3; ++k) {
      Real& a = f[half + 3 * p + k];
      a = p % n == n - 1 ? 0 : a / mass;  // the last of each row is fixed
    }
}

/// One step of H by the modified midpoint rule in 2, 4, ..., 16 parts, extrapolated in H^2.
void advance(State& y, Real H) {
  constexpr int columns = 8;
  std::array<State, columns> table;
  State f(y.size());
  for (int j = 0; j < columns; ++j) {
    const int parts = 2 * (j + 1);
    const Real h = H / parts;
    State before = y, now = y;
    slope(y, f);
    for (std::size_t i = 0; i < y.size(); ++i) now[i] += h * f[i];
    for (int m = 1; m < parts; ++m) {
      slope(now, f);
      for (std::size_t i = 0; i < y.size(); ++i) before[i] += 2 * h * f[i];
      std::swap(before, now);
    }
    table[j] = now;
    for (int k = j; k > 0; --k) {
      const Real ratio = Real(j + 1) / k;
      for (std::size_t i = 0; i < y.size(); ++i)
        table[k - 1][i] = table[k][i] + (table[k][i] - table[k - 1][i]) / (ratio * ratio - 1);
    }
  }
  y = table[0];
}

int main(int argc, char** argv) {
  const int steps_a_quarter = argc > 1 ? std::atoi(argv[1]) : 160;
  State y = initial();
  std::puts("t,component,value");
  for (int quarter = 1; quarter <= 8; ++quarter) {
    for (int step = 0; step < steps_a_quarter; ++step) advance(y, Real(0.25) / steps_a_quarter);
    if ((quarter & (quarter - 1)) != 0) continue;
    for (std::size_t i = 0; i < y.size(); ++i) {
      std::array<char, 64> digits;
      quadmath_snprintf(digits.data(), digits.size(), "%.20Qg", y[i]);
      std::printf("%g,%zu,%s\n", quarter / 4.0, i, digits.data());
    }
  }
}
