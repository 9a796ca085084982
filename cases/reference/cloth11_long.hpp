// SPDX-License-Identifier: BSD-3-Clause
// The cloth of cases/cloth.cpp in a real type of one's choice, for the programs beside this file;
// independent of Odeum's code.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

constexpr int n = 11, particles = n * n, half = 3 * particles;
constexpr double stiffness = 10, damping = 0.05, gravity = -9.8, mass = 3. / particles;

template <class Real>
using State = std::vector<Real>;  // all positions, then all velocities

struct Spring {
  int a, b;
  double rest;
};

inline double place(int i) { return static_cast<double>(i) / (n - 1); }

inline std::vector<Spring> springs() {
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
inline const std::vector<Spring> all_springs = springs();

template <class Real>
State<Real> initial() {
  State<Real> y(2 * half);
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

/// A spring from its end a to its end b.
template <class Real>
std::array<Real, 3> difference(const State<Real>& y, const Spring& s) {
  return {y[3 * s.b] - y[3 * s.a], y[3 * s.b + 1] - y[3 * s.a + 1],
          y[3 * s.b + 2] - y[3 * s.a + 2]};
}

template <class Real>
Real square(const std::array<Real, 3>& d) {
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}

/// f = y'; stretch(squared length, rest length) is 1 - rest / length where a spring pulls or
/// pushes.
template <class Real, class Stretch>
void slope(const State<Real>& y, State<Real>& f, Stretch stretch) {
  for (int i = 0; i < half; ++i) {
    f[i] = y[half + i];
    f[half + i] = i % 3 == 1 ? Real(mass) * gravity : 0;
  }
  for (const Spring& s : all_springs) {
    const std::array<Real, 3> d = difference(y, s);
    const Real pull = stiffness * stretch(square(d), Real(s.rest));
    for (int k = 0; k < 3; ++k) {
      const Real w = y[half + 3 * s.b + k] - y[half + 3 * s.a + k];
      const Real force = pull * d[k] + damping * w;
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

/// y after one step of H by the modified midpoint rule in 2, 4, ..., 2 `columns` parts,
/// extrapolated in H^2.
template <int columns, class Real, class Stretch>
State<Real> advanced(const State<Real>& y, Real H, Stretch stretch) {
  std::array<State<Real>, columns> table;
  State<Real> f(y.size());
  for (int j = 0; j < columns; ++j) {
    const int parts = 2 * (j + 1);
    const Real h = H / parts;
    State<Real> before = y, now = y;
    slope(y, f, stretch);
    for (std::size_t i = 0; i < y.size(); ++i) now[i] += h * f[i];
    for (int m = 1; m < parts; ++m) {
      slope(now, f, stretch);
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
