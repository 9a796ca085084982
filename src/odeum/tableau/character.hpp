// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <functional>
#include <string>

#include "odeum/tableau/dynamic_tableau.hpp"

namespace odeum {

/// Structural properties of a Runge-Kutta method, read off its coefficients.
struct Structure {
  enum class Kind { explicit_stages, diagonally_implicit, fully_implicit };
  Kind kind = Kind::explicit_stages;
  bool one_diagonal = false;          ///< all implicit stages have the same a_ii (SDIRK, ESDIRK)
  bool first_stage_explicit = false;  ///< of an implicit method (ESDIRK, Lobatto)
  bool first_same_as_last = false;    ///< explicit, and the last stage is the next step's first
  bool stiffly_accurate = false;      ///< the last row of A is b
  bool symplectic = false;  ///< b_i a_ij + b_j a_ji = b_i b_j (Sanz-Serna 1988, Lasagni 1988)
  bool symmetric = false;   ///< a_{s+1-i,s+1-j} + a_ij = b_j: the step with -h undoes that with h
  bool operator==(const Structure&) const = default;
};

/// Coefficients count as equal where they agree to 1e-13 of the larger one or of 1: several
/// roundings of short calculations in double.
Structure structure_of(const DynamicTableau<double>& tableau);
/// "explicit, first same as last", "singly diagonally implicit, stiffly accurate", ...
std::string describe(const Structure& structure);

/// R(z) = 1 + z b^T (I - z A)^{-1} 1 for z = `at`, in long double; NaN where I - z A is singular.
std::complex<double> stability_function(const DynamicTableau<double>& t, std::complex<double> at);

/// How a method damps y' = z y for z in the left half-plane.
struct StabilityClass {
  double angle = 0;  ///< A(alpha)-stable with this alpha, in degrees; 90: A-stable; 0: with none
  double at_infinity = 0;  ///< |R(z)| for z -> -infinity; inf for explicit methods
  bool a_stable() const { return angle >= 90; }
  bool l_stable() const { return a_stable() && vanishes_at_infinity(); }
  bool vanishes_at_infinity() const { return at_infinity < 1e-9; }
};
/// "L-stable", "A-stable, |R(inf)| = 1", "A(alpha)-stable, alpha = 73.35, ...", "not
/// A(alpha)-stable".
std::string describe(const StabilityClass& stability);

/// From |R(z)| as a function of z: the widest sector about the negative real axis on whose edges
/// |R| <= 1 + 1e-12 at every sample (1e-6 < |z| < 1e9, forty points per decade). By the maximum
/// principle a bound on the edges holds in the sector, provided that no pole lies within; the real
/// axis and two rays inside are sampled for that.
StabilityClass stability_class(const std::function<double(std::complex<double>)>& amplification);
StabilityClass stability_class(const DynamicTableau<double>& tableau);

}  // namespace odeum
