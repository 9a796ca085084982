// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "odeum/core/numbers.hpp"

namespace odeum::judge {

/// The result of comparing a measured order with the claimed one.
enum class Verdict {
  confirmed,
  higher,
  lower,
  floors,
  undetermined,
  failed,
  over_budget,
  not_applicable
};

const char* to_string(Verdict verdict);

/// Why a fit with the verdict `undetermined`, `failed` or `over_budget` has no order. Whoever makes
/// the runs adds what a fit cannot know: `refused` to `budget_ends`.
enum class NoOrder {
  none,            ///< another verdict
  refused,         ///< the solver does not take this problem or these settings
  newton_failed,   ///< at every step
  step_too_small,  ///< the step control gave up at every tolerance
  unstable,        ///< at every step: not finite, or many times the solution
  over_budget,     ///< at every setting
  budget_ends,     ///< before the order shows
  few_solved,      ///< too few steps give an error that converges
  few_points,      ///< too few errors are clear of rounding
  wide_interval,   ///< of the slope
  unsettled,       ///< slopes still move, or lie between whole orders over too few steps
  denied,          ///< by finer steps
  rejections       ///< of a large share of its tries: its control does not find its steps
};

const char* to_string(NoOrder why);

/// An error measured at a step size, and what is known beforehand of the errors that are not the
/// method's.
struct ErrorPoint {
  double step = 0;
  double error = 0;     ///< NaN where the solve failed
  double steps = 0;     ///< how many steps were taken
  double rejected = 0;  ///< how many more were tried
  /// What rounding comes to for each root of the number of steps: half a unit in the last place of
  /// the measured state, times what the problem makes of perturbations, see amplification.hpp.
  double rounding_unit = 0;
  double floor = 0;       ///< error of the truth itself
  double scale = 0;       ///< size of what is measured; 0: not known
  double components = 1;  ///< how many the error is a root mean square over

  /// The error expected of rounding at random in every step.
  double typical_rounding() const;
  /// Above it local slopes show the method's error. Over many components rounding is independent of
  /// the error and adds to it by squares, so that less of a margin is needed.
  double clear_error() const;
  /// Above it an error is not rounding. Own methods' rounding lies within a factor of 60 of what is
  /// typical (large stage weights, linear systems, the same rounding repeated in each step).
  double certain_error() const;
};

/// A measured order: the slope of log error against log step over the asymptotic window.
struct OrderFit {
  Verdict verdict = Verdict::undetermined;
  NoOrder why = NoOrder::none;
  std::string reason;            ///< a sentence, never empty unless confirmed
  double order = nan;            ///< the slope
  double low = nan, high = nan;  ///< its interval, 95 %
  std::size_t points = 0;        ///< in the window
  double step_coarsest = nan, step_finest = nan;
  double floor = nan;       ///< the error at which convergence stops; NaN where it does not
  double floor_step = nan;  ///< the step from which on it does
  std::string floor_scale;  ///< what the floor scales with, in a few words; empty: not known
};

/// The tolerances for confirming or denying a claim.
struct FitTolerance {
  double order = 0;    ///< how far from the claim a slope may lie to confirm it
  double apart = 0;    ///< how far at least, to be another order
  double settled = 0;  ///< how far the local slopes of a window may differ from their mean
  double stray = 0;    ///< the factor by which finer errors may miss the fitted power of the step
  double whole = 0;    ///< how far another order may lie from a whole one, see fit_order
  bool at_least = false;  ///< whether slopes above the claim confirm it, too
};
/// Fixed steps: neighbouring orders are told apart by 0.15. Above order 4 errors fall to rounding
/// before the next term of their expansion is negligible, C h^p (1 + D h): a window in which D h
/// falls from 0.8 to 0.4 has a slope of p + 0.36. Hence 5 % of p, 0.45 at order 9: still less than
/// half of what lies between neighbouring orders. Slopes of sound methods settle for a while
/// between that and twice as much, so that these deny nothing.
inline constexpr FitTolerance fixed_step_tolerance(double claimed_order) {
  const double order = claimed_order > 4 ? 0.05 * claimed_order : 0.15;
  return {.order = order, .apart = 2 * order, .settled = 0.1, .stray = 2, .whole = 0.15};
}
/// Adaptive runs: the steps vary along the run and with the tolerance, so that errors scatter about
/// a power of the mean step; whole orders are still told apart, but slopes need not be whole. The
/// claim is that errors fall with the order at least: pairs whose leading term is small, and steps
/// that follow the solution, show up to 1.5 more at all tolerances above rounding. A pair's lower
/// order carried on shows up to half of one more, so that 0.5 below the claim is the most that
/// confirms it.
inline constexpr FitTolerance adaptive_tolerance(double claimed_order) {
  const double apart = claimed_order > 3 ? 0.15 * claimed_order : 0.5;
  return {.order = 0.5,
          .apart = apart,
          .settled = 1.5,
          .stray = 10,
          .whole = HUGE_VAL,
          .at_least = true};
}

/// Fits the order of points sorted from coarse to fine over the finest window (fit_parts.hpp) clear
/// of rounding and of the truth's floor.
/// - `confirmed`: the slope is the claimed order, or that of the error's first two terms is (see
///   fit_parts.hpp), or a higher one where `at_least` says so, and every finer point that is clear
///   of rounding lies within `stray` of it.
/// - `floors`: finer points stop falling, clear of rounding.
/// - `higher`, `lower`: the slopes have settled at the finest clear points, elsewhere, and do not
///   move towards the claim: the order's interval lies within `whole` of a whole number, at most
///   one above the claim, over a factor of two in the steps, or is that narrow over a factor of
///   eight; or they have fallen below the claim. Between whole orders slopes move by 0.17 from one
///   halving of the step to the next, so that over few steps any number can be read from them.
///   `higher` with an order of NaN: the errors are rounding at all steps.
/// - `undetermined`: none of these, or confirmed while over a third of the tries are rejected at
///   the finest clear tolerances (no sound control that was measured rejects that many there);
///   `failed`: nothing was solved. Whoever makes the runs says `over_budget` instead where the
///   budget ended all of them.
/// A claimed order of NaN gives not_applicable with the measured slope. Errors and steps may have
/// any unit, the same for all points. Throws nothing; thread-safe.
OrderFit fit_order(const std::vector<ErrorPoint>& points, double claimed_order,
                   const FitTolerance& tolerance);

}  // namespace odeum::judge
