// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <string_view>

#include "odeum/core/common_use.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/tableau/order_conditions.hpp"

/// What a file in methods/ holds: a struct whose name is the file's stem and the method's id, with
///
///     static constexpr MethodInfo info{...};
///     template <class P> using Stepper = ...;      // one step on problem P, see below
///
/// and one of the needs below as its base (`static bool fits_problem(const auto& problem)` asks at
/// run time for what only some of the problems behind problem/shared.hpp offer). A method of a
/// family (ExplicitRungeKuttaMethod, SplittingMethod, AdamsMethod, ...) takes the stepper and what
/// follows from its coefficients from the family's base, whose header is all that its file
/// includes; a Runge-Kutta method has its coefficients as `static constexpr const auto& tableau`,
/// which mutation tests alter one by one. A Stepper is built from a problem and has
///
///     Status step(double t, double h, State<P>& y);   // y at t becomes y at t + h
///
/// and, where the method is not self-starting, `void start(double t, double h, const State<P>& y)`,
/// called once before the first step; where it has an embedded row,
/// `Status step(double t, double h, State<P>& y, State<P>& error)` with the error estimate.
/// Adaptive runs then follow (control/one_step.hpp): by the embedded row, else by step doubling. y
/// and error have the problem's size and units; after a status other than ok they are not to be
/// used. A Stepper keeps states of its own: one for each thread.
///
/// A method that chooses its own steps (and possibly order) has in addition, or instead
/// (`fixed_step = false`), the trial steps of a run from t0 to `end` (control/adaptive.hpp),
///
///     template <class P> static auto trial_steps(const P& problem, double t0, const State<P>& y0,
///                                                double end, const Tolerance& tolerance);
///                                                                          // a TrialSteps
///
/// or a complete adaptive run through every stop of the request, for methods without trial steps:
///
///     template <class P> static Outcome integrate(const P& problem, double t0, const State<P>& y0,
///                                                 const Request& request);
///
/// It needs no constraint: `fits` says what a problem must offer.
namespace odeum {

/// How an embedded pair chooses its steps, see ControlFor in control/step_control.hpp.
enum class Control { integral, proportional_integral, dead_band, predictive };

struct MethodInfo {
  std::string_view id;
  std::string_view family{};
  int order = 0;           ///< 0: no claim, since the order varies or the method is exact
  int order_embedded = 0;  ///< order of the embedded row; 0: none
  bool one_step = true;    ///< the next state depends on the present one only
  bool fixed_step = true;  ///< can be run at a fixed step
  /// An adaptive run varies the order too, so that none is claimed for it.
  bool adaptive_order = false;
  Control control = Control::integral;  ///< of an embedded pair
  std::string_view controller{};  ///< of a method with steps of its own: their control in words
  CommonUse common_use = CommonUse::none;
  std::string_view source;
};

/// `info` with the family of a method and the orders that its coefficients are proven to have.
constexpr MethodInfo completed(MethodInfo info, std::string_view family, const auto& coefficients) {
  info.family = family;
  info.order = coefficients.order;
  if constexpr (requires { coefficients.order_hat; }) info.order_embedded = coefficients.order_hat;
  return info;
}

/// On which problems of cases/inlined a method is compiled with the right-hand side inlined, as
/// `static constexpr auto inlined` of it: those that have no stiff case, or those that have one.
enum class Inlined { nonstiff, stiff };

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
      "a second-order problem q'' = a(t, q) whose acceleration does not depend on the velocity";
  template <class P>
  static constexpr bool fits = Separable<P>;
};

/// Fits y' = f_E(t, y) + f_I(t, y), where the problem says which is which.
struct ForSplit {
  static constexpr bool leaves_out_ends = false;  ///< not looked at: it evaluates parts of f
  static constexpr std::string_view needs =
      "a right-hand side that is split into an explicit and an implicit part";
  template <class P>
  static constexpr bool fits = Split<P>;
  template <class P>
  static bool fits_problem(const P& problem) {
    return offers_explicit_part(problem) && offers_implicit_part(problem);
  }
};

/// What follows from the tableau of a Runge-Kutta method. The bases of its families add the
/// stepper, and `described`, the info of a method that is the tableau and nothing else.
template <const auto& T>
struct TableauMethod {
  static constexpr const auto& tableau = T;
  /// |R(z)|, z = re + i im.
  static double amplification(double re, double im) {
    return std::abs(stability_function(T, {re, im}));
  }
};

/// One step of a method at h = 1 on the undamped oscillator q'' = -w^2 q as a matrix on (w q, q'),
/// row-major; from it follows the stability limit of a second-order method.
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
