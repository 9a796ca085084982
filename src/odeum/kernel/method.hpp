// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string_view>

#include "odeum/problem/concepts.hpp"

/// What a file in methods/ holds: a struct whose name is the file's stem and the method's id, with
///
///     static constexpr MethodInfo info{...};
///     template <class P> using Stepper = ...;      // one step on problem P, see below
///
/// and one of the needs below as its base (what a type cannot say, a need asks of the problem:
/// `static bool fits_problem(const auto& problem)`, for abilities that only some of the problems
/// behind problem/shared.hpp have); a Runge-Kutta method shows its coefficients as
/// `static constexpr const auto& tableau`, which tests then alter one by one. A Stepper is built
/// from a problem and has
///
///     Status step(double t, double h, State<P>& y);   // y at t becomes y at t + h
///
/// and, where the method is not self-starting, `void start(double t, double h, const State<P>& y)`,
/// called once before the first step; where it has an embedded row,
/// `Status step(double t, double h, State<P>& y, State<P>& error)` with the error estimate.
namespace odeum {

struct MethodInfo {
  std::string_view id;
  std::string_view family;
  int order;
  int order_embedded = 0;  ///< order of the embedded row; 0: none
  bool one_step = true;    ///< the next state follows from the present one and nothing else
  std::string_view source;
};

/// Fits any problem.
struct ForAnyProblem {
  static constexpr std::string_view needs{};
  template <class P>
  static constexpr bool fits = Ode<P>;
};
/// Fits q'' = a(t, q, v).
struct ForSecondOrder {
  static constexpr std::string_view needs = "a second-order problem q'' = a(t, q, v)";
  template <class P>
  static constexpr bool fits = SecondOrder<P>;
};
/// Fits q'' = a(t, q).
struct ForSeparable {
  static constexpr std::string_view needs =
      "a second-order problem q'' = a(t, q) whose acceleration does not look at the velocity";
  template <class P>
  static constexpr bool fits = Separable<P>;
};

/// One step of a method at h = 1 on the undamped oscillator q'' = -w^2 q as a matrix on (w q, q'),
/// row-major; a second-order method states it, for the theory of its stability.
using OscillatorMap = std::array<double, 4>;

/// The largest modulus of the eigenvalues of a 2 x 2 matrix.
inline double spectral_radius(const OscillatorMap& m) {
  const double half_trace = (m[0] + m[3]) / 2;
  const double determinant = m[0] * m[3] - m[1] * m[2];
  const double discriminant = half_trace * half_trace - determinant;
  if (discriminant < 0) return std::sqrt(determinant);
  return std::abs(half_trace) + std::sqrt(discriminant);
}

}  // namespace odeum
