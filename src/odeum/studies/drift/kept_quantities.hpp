// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"

namespace odeum::study {

/// An invariant of the exact solution of a case.
struct KeptQuantity {
  std::string name;
  std::function<double(const double* y)> value;
  double exact = 0;  ///< its value at the initial state, in the case's units
};

/// The case's energy, where the truth shows that it is constant (a damped system has an energy
/// too), then its invariants.
std::vector<KeptQuantity> kept_quantities(const Case& c);

/// The motion of q'' = -omega^2 q, in the plane of q and q' / omega: a circle at a constant rate.
struct HarmonicMotion {
  double omega = 0;      ///< radians per unit of time
  double amplitude = 0;  ///< in the units of q
  double start = 0;      ///< angle at the initial state, radians

  double amplitude_of(const double* y) const;
  /// The lag of a state behind the exact angle after `elapsed` time, in radians. An angle is known
  /// up to full turns; of these lags the one nearest to `expected` is returned.
  double lag_of(const double* y, double elapsed, double expected) const;
};

/// The harmonic motion of a case; none where it is not a harmonic oscillator.
std::optional<HarmonicMotion> harmonic_motion(const Case& c);

}  // namespace odeum::study
