// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "odeum/judge/order_fit.hpp"

/// What a fit of an order is made of: local slopes of log error against log step and the window in
/// which they agree, the first two terms of the error, and its floor. Points are sorted from coarse
/// to fine; steps and errors may have any unit, the same for all. Nothing throws; thread-safe.
namespace odeum::judge {

/// Student's t, 97.5 %, for 1, 2, ... degrees of freedom; 2.1 for many.
constexpr double student_t(std::size_t freedom) {
  constexpr std::array<double, 14> table{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                                         2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145};
  return freedom <= table.size() ? table[freedom - 1] : 2.1;
}

inline constexpr std::size_t fewest_points = 4;  ///< of a window

/// Keeps the last of several points with the same steps, to which two tolerances may lead.
void merge_same_steps(std::vector<ErrorPoint>& points);

/// True if the method is exact on this problem: its error is rounding from the coarsest step on,
/// and grows with the number of steps, or with its square in recurrences of second differences.
bool is_exact(const std::vector<ErrorPoint>& points);

/// How many of the tries were rejected at the finest two points: the lesser share; 0 of fewer
/// points.
double rejected_share(const std::vector<ErrorPoint>& points);

/// A power law C h^p through points, by least squares in the logarithms.
struct PowerLaw {
  double order = 0;       ///< p
  double half_width = 0;  ///< of the 95 % interval of p
  double log_factor = 0;  ///< log C
  double at(double step) const { return std::exp(log_factor + order * std::log(step)); }
};
PowerLaw fit_power_law(const ErrorPoint* points, std::size_t n);

double local_slope(const ErrorPoint& coarse, const ErrorPoint& fine);
/// The slope to point `end` - 1 from the first whose error is a tenth of the solution at most; NaN
/// where that has less than twice its step.
double slope_of_resolved(const std::vector<ErrorPoint>& points, std::size_t end);
/// The slope to point `fine` from the next whose step is so much coarser that noise does not
/// dominate; from the coarsest where there is none.
double local_slope_to(const std::vector<ErrorPoint>& points, std::size_t fine);

/// A window of neighbouring points; `count` 0: none.
struct Window {
  std::size_t first = 0, count = 0;
  std::size_t end() const { return first + count; }
};

/// The finest window among points [0, end): four points or more, over steps 1.35 apart at least,
/// whose local slopes are positive and differ by `settled` at most from their mean (by half the
/// claimed order's worth of it more among the finest four: high orders settle later), extended by
/// coarser points as long as their slopes agree too.
Window find_window(const std::vector<ErrorPoint>& points, std::size_t end, double claimed_order,
                   double settled);

/// True where the local slopes of a window approach `order` monotonically (the coarsest is ignored)
/// and, continued at their rate, come within `near` of it at steps ten times finer. Needs three
/// slopes; the one before the window counts where it fits in.
bool moves_towards(const std::vector<ErrorPoint>& points, const Window& window, double order,
                   double near);

/// True where the finest three local slopes of points [0, end), and so of those among them that are
/// far above rounding, fall one after the other from about `order` to below it, by more than the
/// order's tolerance in all, and end more than that below it: a term of lower order takes over,
/// which a fit through all slopes averages away. Not of adaptive runs, whose slopes scatter as
/// much.
bool falls_away(const std::vector<ErrorPoint>& points, std::size_t end, double order,
                const FitTolerance& tolerance);

/// Errors by the first two terms of their expansion, e = C h^p |1 + D h|: for errors whose local
/// slopes still change, so that (log h, log e) is not yet a straight line.
struct TwoTermFit {
  double order = 0;                   ///< p, fitted freely
  double log_factor = 0, second = 0;  ///< log C, and D
  double half_width = 0;              ///< of its 95 % interval
  double scatter = 0;                 ///< root mean square of log e beside the fit
  double second_at_finest = 0;        ///< |D h| at the finest step
  double trend = 0;                   ///< the part of it that neighbouring points share
  std::size_t first = 0, points = 0;  ///< the window

  double at(double step) const {
    return std::exp(log_factor + order * std::log(step)) * std::abs(1 + second * step);
  }
};

/// Fits those points at the fine end (or next to it, by up to two) that lie on such a curve and
/// determine p best: at least six, whose scatter is 5 % at most, with no trend, with 1 + D h of one
/// sign and D h at most 1 in size at the finest. None: `points` is 0.
TwoTermFit fit_two_terms(const std::vector<ErrorPoint>& points);

/// The level at which an error stops falling, clear of rounding.
struct ErrorFloor {
  std::size_t first = 0;  ///< of the points that do not fall, up to the finest clear one
  double level = 0;       ///< median of their errors
  double step = 0;        ///< the coarsest of their steps
  std::string scale;      ///< what the level scales with, in a few words
};

/// Finds the floor of points [0, end): the longest run of at least three finest points whose errors
/// fall more slowly than a quarter of an order, though the claimed order would have them fall by
/// the square of `stray`. Four points that stay level also count. None where errors are of the
/// size of the solution; `first` is then `end`.
ErrorFloor find_floor(const std::vector<ErrorPoint>& points, std::size_t end, double claimed_order,
                      double stray);

}  // namespace odeum::judge
