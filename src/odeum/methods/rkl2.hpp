// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/stabilised_rk.hpp"

namespace odeum::methods {

/// Runge, Kutta, Legendre: R_s(z) = 1 - b_s + b_s P_s(1 + w1 z) with Legendre's polynomials,
///
///     w1 = 4 / (s^2 + s - 2),   b_j = (j^2 + j - 2) / (2 j (j + 1)),   b_0 = b_1 = b_2 = 1/3.
///
/// |R| < 1 in the interior of [-(s^2 + s - 2) / 2, 0] without any damping, and smooth profiles stay
/// monotone; s is odd.
struct rkl2_rule {
  static constexpr double error_constant = 1.0 / 18;
  static constexpr bool last_two_only = false;
  static constexpr int most_stages = 401;

  static int count_for(double x) {
    const double within = std::fmin(std::fmax(x, 0.0), 1e9);
    const int s = static_cast<int>(std::ceil((std::sqrt(9 + 8 * within) - 1) / 2));
    return std::clamp(s + (s % 2 == 0 ? 1 : 0), 3, most_stages);
  }

  static std::vector<StabilisedStage> stages(int s) {
    const auto b = [](int j) {
      const double k = std::max(j, 2);
      return (k * k + k - 2) / (2 * k * (k + 1));
    };
    return stages_of(
        s, 1, 4.0 / (s * s + s - 2), b, [](int) { return 1.0; },
        [](int j) { return std::pair((2.0 * j - 1) / j, (j - 1.0) / j); });
  }
};

struct rkl2 : StabilisedMethod<rkl2_rule> {
  static constexpr MethodInfo info{
      .id = "rkl2",
      .family = "stabilised_rk",
      .order = 2,
      .order_embedded = 2,
      .source = "Meyer, Balsara, Aslam, J. Comput. Phys. 257 (2014) 594-626, (16)-(20)"};
};

}  // namespace odeum::methods
