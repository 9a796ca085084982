// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/orthogonal_stages.hpp"

namespace odeum::methods {

/// Orthogonal Runge, Kutta, Chebyshev of order 4: R_s(z) = w(z) P_{s-4}(z), see
/// weighted_chebyshev.hpp, stable on [-0.35 s^2, 0]. The recurrence of P makes s - 4 stages. A
/// method W of four stages follows, such that its composition with P meets all eight conditions of
/// order 4 (and so has the stability function w). Two of its ten coefficients are free: a_41 =
/// a_42 = 0. |R(z)| <= 0.95 but near 0.
struct rock4_rule {
  static constexpr WeightedFamily<2> family{0.5, 0.87, {{{-13.9, 7.62}, {-1.2, 20.6}}}};
  static constexpr bool last_two_only = true;
  static constexpr int most_stages = 400;

  static int count_for(double x) {
    // The interval is longer than 0.35 s^2 - 2.9.
    // A radius that is not a number has the least count: fmax and fmin leave it out.
    const double count = std::ceil(std::sqrt((x + 2.9) / 0.35));
    return static_cast<int>(std::fmin(std::fmax(count, 5.0), most_stages));
  }

  struct Coefficients {
    std::vector<StabilisedStage> stages;
    LastStages last;
    bool found = false;
  };
  static Coefficients computed(int s) {
    const WeightedPolynomial<2> r = weighted_polynomial(family, s);
    const OrthogonalStages p(r);
    Coefficients all{p.stages, {}, false};
    LastStages& last = all.last;
    std::array<ElementaryWeights, 4> k{};
    const auto defects = [&](const std::array<double, 8>& x) {
      last.a = {{{}, {x[0]}, {x[1], x[2]}, {0, 0, x[3]}, {x[4], x[5], x[6], x[7]}}};
      ElementaryWeights y{};
      for (std::size_t i = 0; i < 5; ++i) {
        y = p.now;
        for (std::size_t j = 0; j < i; ++j) add_multiple(last.a[i][j], k[j], y);
        last.c[i] = y[0];
        if (i < 4) k[i] = slope_of(y);
      }
      add_multiple(-1, exact_weights, y);
      return y;
    };
    std::array<double, 8> x{0.26, -0.16, 0.48, 0.71, 0.03, 0.30, 0.24, 0.11};
    all.found = solve_by_newton(x, defects) && r.found;
    defects(x);
    estimate(k, last);
    return all;
  }

  /// Computed once a program: some 200 microseconds for 20 stages.
  static const std::vector<StabilisedStage>& stages(int s) { return kept(s).stages; }
  static const LastStages& last_stages(int s) { return kept(s).last; }
  static const Coefficients& kept(int s) { return kept_by_degree<most_stages, computed>(s); }

 private:
  /// The weights less those of order 3 of which that of f(y_{n+1}) is a tenth: sum_i estimate_i k_i
  /// = O(h^3), four conditions for the others.
  static void estimate(const std::array<ElementaryWeights, 4>& k, LastStages& last) {
    constexpr double of_last = -0.1;
    linear::DenseLu lu(4);
    const ElementaryWeights end = slope_of(exact_weights);
    for (std::size_t tree = 0; tree < 4; ++tree) {
      for (std::size_t i = 0; i < 4; ++i) lu.data()[tree * 4 + i] = k[i][tree];
      last.estimate[tree] = -of_last * end[tree];
    }
    if (lu.factorise()) lu.solve(last.estimate.data());
    last.estimate[4] = of_last;
  }
};

struct rock4 : StabilisedMethod<rock4_rule> {
  static constexpr MethodInfo info{.id = "rock4",
                                   .family = "stabilised_rk",
                                   .order = 4,
                                   .order_embedded = 3,
                                   .source =
                                       "Abdulle, SIAM J. Sci. Comput. 23 (2002) 2041-2054; W "
                                       "and the estimate are chosen here"};
};

}  // namespace odeum::methods
