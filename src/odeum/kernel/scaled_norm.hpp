// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <utility>

#include "odeum/core/tolerance.hpp"
#include "odeum/kernel/components.hpp"

namespace odeum {

/// The scale of errors of a state: relative (threshold_i + size) for a component of that size.
template <class S>
class ErrorScale {
 public:
  ErrorScale() = default;
  /// `like`: a state, for its size.
  ErrorScale(const Tolerance& tolerance, S like)
      : relative_(tolerance.relative), thresholds_(std::move(like)) {
    for (std::size_t i = 0; i < thresholds_.size(); ++i)
      thresholds_[i] = static_cast<typename S::value_type>(tolerance.threshold(i));
  }

  double relative() const { return relative_; }
  template <class Real>
  auto operator()(std::size_t i, Real size) const {
    return relative_ * (thresholds_[i] + size);
  }

 private:
  double relative_ = 0;
  S thresholds_{};
};

/// sum_i (x_i w_i)^2, with weights that are 1 over the scale of each component.
template <class S>
double scaled_squares(const S& x, const S& weights) {
  return sum_of_components(x, [&](std::size_t i) {
    const double scaled = x[i] * weights[i];
    return scaled * scaled;
  });
}

/// Root of the mean over the components of (x_i w_i)^2.
template <class S>
double scaled_norm(const S& x, const S& weights) {
  return std::sqrt(scaled_squares(x, weights) / static_cast<double>(x.size()));
}

}  // namespace odeum
