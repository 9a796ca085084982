// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/stabilised_rk.hpp"

namespace odeum::methods {

/// Runge, Kutta, Chebyshev: R_s(z) = 1 - b_s T_s(w0) + b_s T_s(w0 + w1 z) with w0 = 1 + eps / s^2,
///
///     w1 = T_s'(w0) / T_s''(w0),   b_j = T_j''(w0) / T_j'(w0)^2,   b_0 = b_1 = b_2.
///
/// The damping eps = 2/13 keeps |R| near 1 - eps/3 inside, at the cost of 2 % of the interval
/// [-2/3 (s^2 - 1) (1 - 2/15 eps), 0].
struct rkc2_rule {
  static constexpr double damping = 2.0 / 13, error_constant = 1.0 / 15;
  static constexpr bool last_two_only = false;
  static constexpr int most_stages = 400;

  static int count_for(double x) {
    // The interval of the code RKC, a little inside.
    const double within = std::fmin(std::fmax(x, 0.0), 1e9);
    return std::clamp(1 + static_cast<int>(std::sqrt(1 + 1.54 * within)), 2, most_stages);
  }

  static std::vector<StabilisedStage> stages(int s) {
    const double w0 = 1 + damping / (s * s);
    // T_j, T_j' and T_j'' at w0.
    std::vector<double> value{1, w0}, slope{0, 1}, curvature{0, 0};
    for (std::size_t j = 2; j <= static_cast<std::size_t>(s); ++j) {
      value.push_back(2 * w0 * value[j - 1] - value[j - 2]);
      slope.push_back(2 * value[j - 1] + 2 * w0 * slope[j - 1] - slope[j - 2]);
      curvature.push_back(4 * slope[j - 1] + 2 * w0 * curvature[j - 1] - curvature[j - 2]);
    }
    const auto b = [&](int j) {
      const auto at = static_cast<std::size_t>(std::max(j, 2));
      return curvature[at] / (slope[at] * slope[at]);
    };
    return stages_of(
        s, w0, slope.back() / curvature.back(), b,
        [&](int j) { return value[static_cast<std::size_t>(j)]; },
        [](int) { return std::pair(2.0, 1.0); });
  }
};

struct rkc2 : StabilisedMethod<rkc2_rule> {
  static constexpr MethodInfo info{
      .id = "rkc2",
      .family = "stabilised_rk",
      .order = 2,
      .order_embedded = 2,
      .source =
          "Sommeijer, Shampine, Verwer, J. Comput. Appl. Math. 88 (1998) 315-326, (2.1)-(2.6), "
          "(3.1); Hairer, Wanner, Solving ODEs II, IV.2"};
};

}  // namespace odeum::methods
