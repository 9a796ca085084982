// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/proof/any_stepper.hpp"

namespace odeum::proof {

/// The quality of a pair's error estimate on a problem with known solution.
///
/// The estimate is the difference of two results of orders p and q. Where these differ it is, as h
/// goes to zero, the error of the lower one: its exponent in h is min(p, q) + 1 and its ratio to
/// the true local error of that result goes to 1. A pair may meet every order condition and still
/// have a ratio far from 1 at practical steps.
struct EstimateQuality {
  std::string test_problem;
  double exponent = 0, expected_exponent = 0;  ///< of h; NaN: no window, or no estimate at all
  /// Estimate over true local error of the lower-order result, where the estimate is near 1e-6.
  double ratio = 0;
  /// Estimate over true local error of the propagated result; below 1 it underestimates.
  double margin = 0;
  bool right_exponent() const;  ///< to 6 %
  bool good() const;            ///< and the ratio is within the band
};

/// A factor of three either way: a step chosen by such an estimate is wrong by at most a factor of
/// 1.7 at q = 1.
inline constexpr double ratio_low = 1. / 3, ratio_high = 3;

/// On the test problems of the method's kind and, for methods of any problem, on `quadrature`, y' =
/// f(t), where the estimate of some pairs is zero.
std::vector<EstimateQuality> estimate_quality(const MakeStepper<FunctionProblem>& make, int order,
                                              int order_embedded);
std::vector<EstimateQuality> estimate_quality(const MakeStepper<FunctionMechanics<false>>& make,
                                              int order, int order_embedded);

}  // namespace odeum::proof
