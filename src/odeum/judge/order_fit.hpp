// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace odeum::judge {

/// What a measured order says of a claimed one.
enum class Verdict { confirmed, higher, lower, floors, undetermined, failed, not_applicable };

const char* to_string(Verdict verdict);

/// An error measured at a step size.
struct ErrorPoint {
  double step = 0;
  double error = 0;          ///< NaN where the solve failed
  double steps = 0;          ///< how many steps were taken
  double rounding_unit = 0;  ///< half a unit in the last place of what is measured
  double floor = 0;          ///< error that the truth itself leaves open
  double components = 1;     ///< how many the error is a root mean square over

  /// What rounding comes to if steps round at random, and what the truth leaves open.
  double typical_rounding() const;
};

/// A measured order: the slope of log error against log step over the asymptotic window.
struct OrderFit {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Verdict verdict = Verdict::undetermined;
  std::string reason;            ///< a sentence, never empty unless confirmed
  double order = nan;            ///< the slope
  double low = nan, high = nan;  ///< its interval, 95 %
  std::size_t points = 0;        ///< in the window
  double step_coarsest = nan, step_finest = nan;
  double floor = nan;  ///< smallest error seen where convergence stops; NaN where it does not
};

/// How far from the claim a slope may lie to confirm it, and how far the local slopes of a window
/// may stray from each other.
struct FitTolerance {
  double order;
  double settled;
};
/// Fixed steps: two neighbouring orders are told apart with room to spare. Orders above 4 fall to
/// rounding before their slopes settle as well, hence a tolerance of 5 % for them.
inline constexpr FitTolerance fixed_step_tolerance(double claimed_order) {
  return {.order = claimed_order > 4 ? 0.05 * claimed_order : 0.15, .settled = 0.1};
}
/// Adaptive runs: the steps vary along the run and with the tolerance, so that the mean step is a
/// loose yardstick; whole orders are still told apart.
inline constexpr FitTolerance adaptive_tolerance(double claimed_order) {
  return {.order = claimed_order > 3 ? 0.15 * claimed_order : 0.5, .settled = 1.5};
}

/// Fits the order of points sorted from coarse to fine. The window is found, never chosen by hand:
/// its fine end is where errors meet rounding (what it comes to as a rule, or in this very run
/// where that shows) or stop falling, its coarse end where the local slopes settle. A verdict of
/// confirmed needs at least four points in the window, or six that lie on the error's first two
/// terms, see two_term_fit.hpp. A claimed order of NaN gives not_applicable with the measured
/// slope.
OrderFit fit_order(const std::vector<ErrorPoint>& points, double claimed_order,
                   const FitTolerance& tolerance);

}  // namespace odeum::judge
