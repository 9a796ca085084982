// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace odeum {

/// Convergence threshold of Newton and fixed-point corrections, relative to the largest component
/// of the state: far below the truncation errors that a study resolves, and far enough above
/// rounding to be reached.
inline constexpr double iteration_tolerance = 1e-13;
/// Corrections to a state smaller than this are measured against it: subnormal numbers have no
/// digits left to converge in.
inline constexpr double smallest_state = 1e15 * std::numeric_limits<double>::min();

/// Relative residual of Newton's linear systems: the next correction removes the rest, and it is
/// far below the contraction that the iteration accepts.
inline constexpr double correction_accuracy = 1e-8;

/// Whether an iteration has reached rounding. `size`: of the last correction, in units of
/// iteration_tolerance; `rate`: its contraction, where that is known. What later corrections would
/// add must lie below 2^-53, since remainders of equal sign add up over the steps, divided by the
/// `weight` with which the method multiplies it; a small correction that contracts no more is
/// rounding.
inline bool at_rounding(double size, double rate, bool rate_known, double weight = 1) {
  constexpr double contracts = 0.05;
  const double unseen = 1e-3 / weight;
  return size <= unseen || (size <= 1 && rate_known && (rate > contracts || size * rate <= unseen));
}

/// The largest modulus of the components; NaN where one is NaN.
template <class S>
double max_norm(const S& x) {
  double norm = 0;
  for (const double component : x) {
    if (std::isnan(component)) return component;
    norm = std::max(norm, std::abs(component));
  }
  return norm;
}

}  // namespace odeum
