// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "odeum/scene/surface/surface_law.hpp"

namespace odeum::scene {

/// A number with its derivatives by N unknowns; with Lanes a vector of numbers.
template <std::size_t N, class Number = double>
struct Slopes {
  Number value = 0;
  std::array<Number, N> by;

  Slopes() : Slopes(0.0) {}
  Slopes(double x) : Slopes(constant(Number(x))) {}  // NOLINT(google-explicit-constructor): mixes
  Slopes(const Number& x, std::size_t unknown) : Slopes(constant(x)) { by[unknown] = 1; }

  static Slopes constant(const Number& x) {
    Slopes result(Unset{});
    result.value = x;
    result.by.fill(Number(0));
    return result;
  }
  /// f(a, b) with the derivatives da and db.
  static Slopes of(const Number& f, const Number& da, const Slopes& a, const Number& db,
                   const Slopes& b) {
    Slopes result(Unset{});
    result.value = f;
    for (std::size_t k = 0; k < N; ++k) result.by[k] = da * a.by[k] + db * b.by[k];
    return result;
  }
  template <class Use>
  static Slopes each(const Number& f, const Use& use) {
    Slopes result(Unset{});
    result.value = f;
    for (std::size_t k = 0; k < N; ++k) result.by[k] = use(k);
    return result;
  }
  friend Slopes operator+(const Slopes& a, const Slopes& b) {
    return each(a.value + b.value, [&](std::size_t k) { return a.by[k] + b.by[k]; });
  }
  friend Slopes operator-(const Slopes& a, const Slopes& b) {
    return each(a.value - b.value, [&](std::size_t k) { return a.by[k] - b.by[k]; });
  }
  friend Slopes operator-(const Slopes& a) {
    return each(-a.value, [&](std::size_t k) { return -a.by[k]; });
  }
  friend Slopes operator*(const Slopes& a, const Slopes& b) {
    return of(a.value * b.value, b.value, a, a.value, b);
  }
  friend Slopes operator/(const Slopes& a, const Slopes& b) {
    const Number inverse = 1 / b.value, quotient = a.value * inverse;
    return of(quotient, inverse, a, -quotient * inverse, b);
  }
  // Constants have no derivatives, and no products with them.
  friend Slopes operator+(double a, const Slopes& b) { return b + a; }
  friend Slopes operator+(const Slopes& a, double b) {
    Slopes result = a;
    result.value = a.value + b;
    return result;
  }
  friend Slopes operator-(const Slopes& a, double b) { return a + -b; }
  friend Slopes operator-(double a, const Slopes& b) { return -b + a; }
  friend Slopes operator*(double a, const Slopes& b) { return b * a; }
  friend Slopes operator*(const Slopes& a, double b) {
    return each(a.value * b, [&](std::size_t k) { return a.by[k] * b; });
  }
  friend Slopes operator/(double a, const Slopes& b) {
    const Number inverse = 1 / b.value, quotient = a * inverse, factor = -quotient * inverse;
    return each(quotient, [&](std::size_t k) { return factor * b.by[k]; });
  }
  friend Slopes sqrt(const Slopes& a) {
    using std::sqrt;
    const Number root = sqrt(a.value), factor = 0.5 / root;
    return each(root, [&](std::size_t k) { return factor * a.by[k]; });
  }
  friend auto operator<(const Slopes& a, const Slopes& b) { return a.value < b.value; }
  friend auto operator>(const Slopes& a, const Slopes& b) { return a.value > b.value; }
  template <class Mask>
  friend Slopes select(const Mask& first, const Slopes& a, const Slopes& b) {
    return each(select(first, a.value, b.value),
                [&](std::size_t k) { return select(first, a.by[k], b.by[k]); });
  }

 private:
  struct Unset {};
  explicit Slopes(Unset) {}
};

}  // namespace odeum::scene
