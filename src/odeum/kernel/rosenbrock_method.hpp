// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "odeum/kernel/method.hpp"
#include "odeum/kernel/rosenbrock.hpp"

namespace odeum {

/// Base of a Rosenbrock method.
template <const auto& T>
struct RosenbrockMethod {
  static constexpr const auto& rosenbrock_tableau = T;
  template <class P>
  using Stepper = Rosenbrock<T, P>;
  /// |R(z)|: on a linear problem alpha + Gamma is the matrix of a Runge-Kutta method.
  static double amplification(double re, double im) {
    static constexpr auto linear = T.linear_tableau();
    return std::abs(stability_function(linear, {re, im}));
  }
  static constexpr MethodInfo described(MethodInfo info) {
    return completed(info, "linearly_implicit", T);
  }
};

}  // namespace odeum
