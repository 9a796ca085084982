// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "support/text_case.hpp"

namespace odeum::cases {

/// The truth of a problem from text, in double and in extended precision.
struct TextTruth {
  Truth truth;
  std::function<bool(double t, long double* y)> extended;
  double extended_floor = 0;
  /// Those of the problem's stops at which the truth is known; where it is known at none, the last
  /// time at which it is; empty: at no time.
  std::vector<double> stops;
  double known_until = 0;
  std::string words;  ///< for people: where it comes from and how many digits it has
};

TextTruth truth_of(const std::shared_ptr<const formula::TextOde>& ode);

}  // namespace odeum::cases
