// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>

namespace odeum {

/// sum_i (x_i w_i)^2, with weights that are 1 over the scale of each component.
template <class S>
double scaled_squares(const S& x, const S& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double scaled = x[i] * weights[i];
    sum += scaled * scaled;
  }
  return sum;
}

/// Root of the mean over the components of (x_i w_i)^2.
template <class S>
double scaled_norm(const S& x, const S& weights) {
  return std::sqrt(scaled_squares(x, weights) / static_cast<double>(x.size()));
}

}  // namespace odeum
