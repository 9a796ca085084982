// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/orthogonal_stages.hpp"

namespace odeum::methods {

/// Orthogonal Runge, Kutta, Chebyshev: R_s(z) = w(z) P_{s-2}(z), see weighted_chebyshev.hpp, stable
/// on [-0.81 s^2, 0] where rkc2 reaches 0.65 s^2. The recurrence of P makes s - 2 stages, the last
/// two w(z) = 1 + 2 sigma z + tau z^2:
///
///     K_{s-1} = K_{s-2} + h sigma F_{s-2},
///     K_s = K_{s-1} + h sigma F_{s-1} - h sigma (1 - tau / sigma^2) (F_{s-1} - F_{s-2}).
///
/// |R(z)| <= 0.95 but near 0. No other start gives an interval that is longer by 0.1 %.
struct rock2_rule {
  static constexpr WeightedFamily<1> family{0.3, 0.945, {{{-3.0, 3.37}}}};
  // 1/6 - sum b_i a_ij c_j; (1/3 - sum b_i c_i^2) / 2, the other term, is 0.015.
  static constexpr double error_constant = 0.07;
  static constexpr bool last_two_only = true;
  static constexpr int most_stages = 400;

  static int count_for(double x) {
    // The interval is longer than 0.807 s^2 - 1.2.
    // A radius that is not a number has the least count: fmax and fmin leave it out.
    const double count = std::ceil(std::sqrt((x + 1.2) / 0.807));
    return static_cast<int>(std::fmin(std::fmax(count, 3.0), most_stages));
  }

  static std::vector<StabilisedStage> computed(int s) {
    OrthogonalStages p(weighted_polynomial(family, s));
    // Order 2: P' + 2 sigma = 1 and P'' / 2 + 2 sigma P' + tau = 1 / 2 at 0.
    const double sigma = (1 - p.now[0]) / 2, tau = 0.5 - p.now[1] - 2 * sigma * p.now[0];
    p.add(1, sigma);
    // h sigma F_{s-2} = K_{s-1} - K_{s-2}.
    p.add(2 - tau / (sigma * sigma), tau / sigma);
    return p.stages;
  }

  /// Computed once a program: some 50 microseconds for 20 stages.
  static const std::vector<StabilisedStage>& stages(int s) {
    return kept_by_degree<most_stages, computed>(s);
  }
};

struct rock2 : StabilisedMethod<rock2_rule> {
  static constexpr MethodInfo info{
      .id = "rock2",
      .family = "stabilised_rk",
      .order = 2,
      .order_embedded = 2,
      .source = "Abdulle, Medovikov, Numer. Math. 90 (2001) 1-18; the estimate is that of rkc2"};
};

}  // namespace odeum::methods
