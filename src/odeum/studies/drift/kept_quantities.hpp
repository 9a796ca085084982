// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"

namespace odeum::study {

/// What the exact solution of a case keeps for all time.
struct KeptQuantity {
  std::string name;
  std::function<double(const double* y)> value;
  double exact = 0;  ///< its value at the initial state, in the case's units
};

/// The case's invariants, and its energy where that is kept: a damped system has an energy too, so
/// the truth is asked whether it changes. In the order energy, invariants.
std::vector<KeptQuantity> kept_quantities(const Case& c);

/// The motion of q'' = -omega^2 q, in the plane of q and q' / omega: a circle at a constant rate.
struct HarmonicMotion {
  double omega = 0;      ///< radians per unit of time
  double amplitude = 0;  ///< in the units of q
  double start = 0;      ///< angle at the initial state, radians

  double amplitude_of(const double* y) const;
  /// How far a state is behind the exact angle after `elapsed` time, in radians. An angle is known
  /// up to full turns only: the answer is the one nearest to `expected`.
  double lag_of(const double* y, double elapsed, double expected) const;
};

/// The harmonic motion that a case is; none where it is something else.
std::optional<HarmonicMotion> harmonic_motion(const Case& c);

}  // namespace odeum::study
