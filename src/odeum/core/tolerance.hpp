// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace odeum {

/// What the error of a step is held to: relative |y_i| + absolute_i for component i, which is
/// relative (threshold_i + |y_i|). The threshold absolute_i / relative is the size of y_i below
/// which its error counts absolutely (Shampine, Reichelt, The MATLAB ODE suite, SIAM J. Sci.
/// Comput. 18 (1997), section 3).
struct Tolerance {
  double relative;
  std::vector<double> thresholds = {};  ///< by component, or one for all; empty: 1

  /// Relative and absolute tolerance, the same number.
  Tolerance(double both) : relative(both) {}
  Tolerance(double relative_one, double absolute)
      : Tolerance(relative_one, std::vector<double>{absolute}) {}
  /// Absolute ones by component, or one for all; none: the same number as the relative one.
  Tolerance(double relative_one, std::vector<double> absolute)
      : relative(relative_one), thresholds(absolute), absolutes_(std::move(absolute)) {
    for (double& each : thresholds) each /= relative;
  }
  static Tolerance of_thresholds(double relative_one, std::vector<double> thresholds) {
    Tolerance made(relative_one);
    made.thresholds = made.absolutes_ = std::move(thresholds);
    for (double& each : made.absolutes_) each *= relative_one;
    return made;
  }

  double threshold(std::size_t i) const { return of_component(thresholds, i, 1); }
  double absolute(std::size_t i) const { return of_component(absolutes_, i, relative); }
  /// The absolute tolerances: one for each component, or one for all; empty: the relative one.
  const std::vector<double>& absolutes() const { return absolutes_; }
  /// Whether components have absolute tolerances of their own.
  bool by_component() const { return absolutes_.size() > 1; }
  /// The same thresholds under another relative tolerance: for a method that holds its estimate to
  /// another number than the one requested.
  Tolerance with_relative(double other) const { return of_thresholds(other, thresholds); }
  /// The same as a request of a user, who states absolute tolerances: the thresholds are those of
  /// the rounded absolute ones, so that a request gives the same run however it was made.
  Tolerance requested(double other) const { return {other, with_relative(other).absolutes_}; }
  /// Whether it is one for a state of n components: positive and finite, with a threshold for each.
  bool sound_for(std::size_t n) const {
    const auto good = [](double x) { return x > 0 && std::isfinite(x); };
    for (const double each : thresholds)
      if (!good(each)) return false;
    return good(relative) && (thresholds.size() <= 1 || thresholds.size() == n);
  }

 private:
  static double of_component(const std::vector<double>& all, std::size_t i, double otherwise) {
    return all.empty() ? otherwise : all[all.size() == 1 ? 0 : i];
  }
  std::vector<double> absolutes_ = {};
};

}  // namespace odeum
