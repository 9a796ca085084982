// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <limits>
#include <span>

/// The growth rate of a linear iteration, measured on its states.
namespace odeum::judge {

/// The growth of a solver at one point of a parameter plane. A solve that failed has NaN.
struct Growth {
  double log_per_step = std::numeric_limits<double>::quiet_NaN();  ///< log |y_{n+1}| / |y_n|
  double noise = 0;  ///< below it the sign of log_per_step is not significant

  bool failed() const { return log_per_step != log_per_step; }
  /// The solution does not stay bounded.
  bool grows() const { return failed() || log_per_step > noise; }
  bool decays() const { return log_per_step < -noise; }
};

/// The resolution of the growth of a step in double: rounding of about a dozen operations.
inline constexpr double growth_rounding = 64 * std::numeric_limits<double>::epsilon();

/// A state of two components, in a norm that is constant on the exact solution of the undamped test
/// problem: (Re y, Im y), or (omega q, q').
using PlaneState = std::array<double, 2>;

/// The type of a recurrence's coefficients: those of a real linear map are real.
enum class Coefficients { real, complex };

/// The growth from the states' lengths, or from a recurrence that they obey. For y' = z y (complex
/// coefficients): the one of the two with less noise. For an oscillator (real ones): the
/// recurrence, and the lengths only where it is not determined, since they vary with twice the
/// oscillator's frequency, too slowly for the window. At least four states, one a step.
Growth dominant_growth(std::span<const PlaneState> states, Coefficients coefficients);

double length(const PlaneState& state);

}  // namespace odeum::judge
