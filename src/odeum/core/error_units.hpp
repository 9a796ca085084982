// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

namespace odeum {

/// What the errors of a case's components are divided by.
struct ErrorUnits {
  std::vector<double> scale = {};  ///< by component, in its own unit; empty: 1
  /// For each component: where it is positive, the error is relative to the exact value, or to this
  /// number where that is smaller, in place of the scale. Empty: nowhere.
  std::vector<double> relative_from = {};

  double scale_of(std::size_t i) const { return scale.empty() ? 1 : scale[i]; }
  bool is_relative(std::size_t i) const { return !relative_from.empty() && relative_from[i] > 0; }
  double of(std::size_t i, double exact) const {
    return is_relative(i) ? std::max(std::abs(exact), relative_from[i]) : scale_of(i);
  }
};

}  // namespace odeum
