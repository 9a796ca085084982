// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace odeum::scene {

/// A number with its derivatives by N unknowns.
template <std::size_t N>
struct Slopes {
  double value = 0;
  std::array<double, N> by{};

  Slopes() = default;
  Slopes(double x) : value(x) {}  // NOLINT(google-explicit-constructor): mixes with numbers
  Slopes(double x, std::size_t unknown) : value(x) { by[unknown] = 1; }

  /// f(a, b) with the derivatives da and db.
  static Slopes of(double f, double da, const Slopes& a, double db, const Slopes& b) {
    Slopes result(f);
    for (std::size_t k = 0; k < N; ++k) result.by[k] = da * a.by[k] + db * b.by[k];
    return result;
  }
  friend Slopes operator+(const Slopes& a, const Slopes& b) {
    return of(a.value + b.value, 1, a, 1, b);
  }
  friend Slopes operator-(const Slopes& a, const Slopes& b) {
    return of(a.value - b.value, 1, a, -1, b);
  }
  friend Slopes operator-(const Slopes& a) { return of(-a.value, -1, a, 0, a); }
  friend Slopes operator*(const Slopes& a, const Slopes& b) {
    return of(a.value * b.value, b.value, a, a.value, b);
  }
  friend Slopes operator/(const Slopes& a, const Slopes& b) {
    const double quotient = a.value / b.value;
    return of(quotient, 1 / b.value, a, -quotient / b.value, b);
  }
  friend Slopes sqrt(const Slopes& a) {
    const double root = std::sqrt(a.value);
    return of(root, 0.5 / root, a, 0, a);
  }
  friend bool operator<(const Slopes& a, const Slopes& b) { return a.value < b.value; }
  friend bool operator>(const Slopes& a, const Slopes& b) { return a.value > b.value; }
};

}  // namespace odeum::scene
