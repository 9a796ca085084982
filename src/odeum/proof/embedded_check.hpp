// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/proof/any_stepper.hpp"

namespace odeum::proof {

/// How good the error estimate of a pair is on a problem whose solution is known.
///
/// The estimate is the difference of two results of orders p and q. Where they differ it tells, as
/// h goes to zero, the error of the lower one: its exponent in h is min(p, q) + 1 and its ratio to
/// the true local error of that result goes to 1. A pair that meets every order condition and whose
/// ratio is far from 1 at a step that one would take still estimates badly.
struct EstimateQuality {
  std::string ground;
  double exponent = 0, expected_exponent = 0;  ///< of h; NaN: no window, or no estimate at all
  /// Estimate over true local error of the lower-order result, where the estimate is near 1e-6.
  double ratio = 0;
  /// Estimate over true local error of the result that is kept; below 1 it is unsafe.
  double margin = 0;
  bool right_exponent() const;  ///< to 6 %
  bool good() const;            ///< and the ratio is within the band
};

/// A factor of three either way: a step chosen by such an estimate at q = 1 is off by 1.7 at most.
inline constexpr double ratio_low = 1. / 3, ratio_high = 3;

/// On the grounds of the kind of problem and, for those of any problem, on `quadrature`, y' = f(t),
/// which some pairs are blind to.
std::vector<EstimateQuality> estimate_quality(const MakeStepper<FunctionProblem>& make, int order,
                                              int order_embedded);
std::vector<EstimateQuality> estimate_quality(const MakeStepper<FunctionMechanics<false>>& make,
                                              int order, int order_embedded);

}  // namespace odeum::proof
