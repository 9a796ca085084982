// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace odeum {

/// What the error of a step is held to: relative |y_i| + absolute_i for component i. It is kept as
/// relative (threshold_i + |y_i|), with the threshold absolute_i / relative: the size of y_i below
/// which its error counts absolutely (Shampine, Reichelt, The MATLAB ODE suite, SIAM J. Sci.
/// Comput. 18 (1997), section 3). A method that holds its estimate to another number than the one
/// requested changes `relative` alone.
struct Tolerance {
  double relative;
  std::vector<double> thresholds = {};  ///< by component, or one for all; empty: 1

  /// Relative and absolute tolerance, the same number.
  Tolerance(double both) : relative(both) {}
  Tolerance(double relative_one, double absolute)
      : Tolerance(relative_one, std::vector<double>{absolute}) {}
  /// Absolute ones by component, or one for all; none: the same number as the relative one.
  Tolerance(double relative_one, std::vector<double> absolute)
      : relative(relative_one), thresholds(std::move(absolute)) {
    for (double& each : thresholds) each /= relative;
  }

  double threshold(std::size_t i) const {
    return thresholds.empty() ? 1 : thresholds[thresholds.size() == 1 ? 0 : i];
  }
  double absolute(std::size_t i) const { return relative * threshold(i); }
  /// The same thresholds under another relative tolerance.
  Tolerance with_relative(double other) const {
    Tolerance changed = *this;
    changed.relative = other;
    return changed;
  }
  /// Whether it is one for a state of n components: positive and finite, with a threshold for each.
  bool sound_for(std::size_t n) const {
    const auto good = [](double x) { return x > 0 && std::isfinite(x); };
    for (const double each : thresholds)
      if (!good(each)) return false;
    return good(relative) && (thresholds.size() <= 1 || thresholds.size() == n);
  }
};

}  // namespace odeum
