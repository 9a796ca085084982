// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace odeum::study {

/// The oscillator z'' + decay z' + omega_squared (z - rest) = 0 that passes through the samples of
/// a motion: exactly so for any linear scheme of two unknowns.
struct Vibration {
  double omega_squared = 0;  ///< k/m, 1/s^2
  double decay = 0;          ///< d/m, 1/s
  double rest = 0;           ///< in the units of z
};

/// Fits z[j + lag] = a z[j] + b z[j - lag] + c by least squares and takes the logarithms of the
/// roots of x^2 = a x + b; the lag is about a sixth of a turn. Samples are `step` s apart; z starts
/// displaced, with velocity 0. Where no oscillator fits, `reason` is a sentence.
std::optional<Vibration> fit_vibration(const std::vector<double>& z, double step,
                                       std::string& reason);

}  // namespace odeum::study
