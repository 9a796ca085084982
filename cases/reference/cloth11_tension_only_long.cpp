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
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

using Real = long double;
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

const std::vector<Spring> all = springs();

/// Whether the length of each spring exceeds its rest length.
std::vector<bool> taut(const State& y) {
  std::vector<bool> result;
  for (const Spring& s : all) {
    Real squared = 0;
    for (int k = 0; k < 3; ++k) {
      const Real d = y[3 * s.b + k] - y[3 * s.a + k];
      squared += d * d;
    }
    result.push_back(squared > s.rest * s.rest);
  }
  return result;
}

void slope(const State& y, State& f) {
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
    const Real stretch = 1 - s.rest / std::sqrt(squared);
    const Real pull = stretch > 0 ? stiffness * stretch : 0;
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

/// One step of H by the modified midpoint rule in 2, 4, 6 and 8 parts, extrapolated in H^2.
State advanced(const State& y, Real H) {
  constexpr int columns = 4;
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
  return table[0];
}

struct Walk {
  State y = initial();
  std::vector<bool> pattern = taut(y);
  Real shortest = 0;
  long kinks = 0;  ///< springs that became taut or slack

  void advance(Real H) {
    const State next = advanced(y, H);
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
