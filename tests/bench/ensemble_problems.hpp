// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

/// Problems of ensembles, as a user of odeum/api/ensemble.hpp writes them.
namespace odeum::bench {

template <class Real>
struct Lorenz {
  using real = Real;
  static constexpr std::size_t dimension = 3;
  Real s{10}, r{28}, b{8. / 3};
  void rhs(Real, const Real* y, Real* f) const {
    f[0] = s * (y[1] - y[0]);
    f[1] = y[0] * (r - y[2]) - y[1];
    f[2] = y[0] * y[1] - b * y[2];
  }
};

template <class Real>
struct Duffing {
  using real = Real;
  static constexpr std::size_t dimension = 2;
  Real alpha{1}, beta{0.5};
  void rhs(Real, const Real* y, Real* f) const {
    f[0] = y[1];
    f[1] = -alpha * y[0] - beta * (y[0] * y[0] * y[0]);
  }
};

template <class Real>
struct LotkaVolterra {
  using real = Real;
  static constexpr std::size_t dimension = 2;
  Real a{1}, b{0.5}, c{1}, d{0.2};
  void rhs(Real, const Real* y, Real* f) const {
    f[0] = y[0] * (a - b * y[1]);
    f[1] = y[1] * (d * y[0] - c);
  }
};

template <class Real>
struct Kepler {
  using real = Real;
  static constexpr std::size_t dimension = 4;
  Real mass{1};
  void rhs(Real, const Real* y, Real* f) const {
    using std::sqrt;
    const Real square = y[0] * y[0] + y[1] * y[1], pull = -mass / (square * sqrt(square));
    f[0] = y[2];
    f[1] = y[3];
    f[2] = pull * y[0];
    f[3] = pull * y[1];
  }
};

/// A driven pendulum: two calls of sin.
template <class Real>
struct Pendulum {
  using real = Real;
  static constexpr std::size_t dimension = 2;
  Real force{1.2}, friction{0.3};
  void rhs(Real t, const Real* y, Real* f) const {
    using std::sin;
    f[0] = y[1];
    f[1] = force * sin(0.7 * t) - sin(y[0]) - friction * y[1];
  }
};

template <class Real>
struct Robertson {
  using real = Real;
  static constexpr std::size_t dimension = 3;
  static constexpr bool autonomous() { return true; }
  Real k1{0.04}, k2{3e7}, k3{1e4};
  void rhs(Real, const Real* y, Real* f) const {
    const Real first = k1 * y[0], second = k2 * y[1] * y[1], third = k3 * y[1] * y[2];
    f[0] = third - first;
    f[1] = first - third - second;
    f[2] = second;
  }
  void jacobian(Real, const Real* y, Real* j) const {
    const Real by1 = k3 * y[2], by2 = k3 * y[1], twice = 2 * k2 * y[1];
    const std::array<Real, 9> rows{-k1, by1, by2, k1, -by1 - twice, -by2, 0, twice, 0};
    std::copy(rows.begin(), rows.end(), j);
  }
};

template <class Real>
struct Hires {
  using real = Real;
  static constexpr std::size_t dimension = 8;
  static constexpr bool autonomous() { return true; }
  Real k{280};
  void rhs(Real, const Real* y, Real* f) const {
    const Real bound = k * y[5] * y[7];
    f[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
    f[1] = 1.71 * y[0] - 8.75 * y[1];
    f[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
    f[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
    f[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
    f[5] = -bound + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
    f[6] = bound - 1.81 * y[6];
    f[7] = -f[6];
  }
  void jacobian(Real, const Real* y, Real* j) const {
    std::fill(j, j + 64, Real(0));
    const Real by5 = k * y[7], by7 = k * y[5];
    j[0] = -1.71, j[1] = 0.43, j[2] = 8.32;
    j[8] = 1.71, j[9] = -8.75;
    j[18] = -10.03, j[19] = 0.43, j[20] = 0.035;
    j[25] = 8.32, j[26] = 1.71, j[27] = -1.12;
    j[36] = -1.745, j[37] = 0.43, j[38] = 0.43;
    j[43] = 0.69, j[44] = 1.71, j[45] = -0.43 - by5, j[46] = 0.69, j[47] = -by7;
    j[53] = by5, j[54] = -1.81, j[55] = by7;
    j[61] = -by5, j[62] = 1.81, j[63] = -by7;
  }
};

}  // namespace odeum::bench
