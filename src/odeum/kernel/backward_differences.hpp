// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/multistep.hpp"
#include "odeum/kernel/newton.hpp"
#include "odeum/tableau/multistep_coefficients.hpp"

namespace odeum {

/// BDF of order K at a fixed step, by Newton's method from the polynomial through the last K
/// states. Formula and guess are summed from the newest state and the differences of neighbours,
/// which are small and exact, so that the alphas do not amplify rounding.
template <std::size_t K, Ode P, class OneStep>
class BackwardDifferences {
 public:
  static constexpr bool solves_equations = true;
  explicit BackwardDifferences(const P& problem)
      : newton_(problem),
        starting_(problem),
        states_(make_state(problem)),
        base_(make_state(problem)) {}

  void start(double, double, const State<P>&) { states_.clear(); }

  Status step(double t, double h, State<P>& y) {
    states_.push() = y;
    if (!states_.full()) return starting_.advance(t, h, y);
    each_component(y, [&](std::size_t n) {
      double sum = 0, guess = 0;
      for (std::size_t i = K - 1; i-- > 0;) {
        const double difference = states_[i][n] - states_[i + 1][n];
        sum += base_weights[i] * difference;
        guess += guess_weights[i] * difference;
      }
      base_[n] = states_[0][n] + sum;
      y[n] = states_[0][n] + guess;
    });
    return newton_.solve(t + h, h / formula.alpha[0], base_, y);
  }

 private:
  static constexpr auto formula = backward_difference_coefficients<K>();
  static_assert(multistep_proven<formula, K>());
  /// Weights of K values that sum to one, as weights of the newest one and of the differences
  /// between neighbours.
  static constexpr auto by_differences(const std::array<double, K>& weights) {
    std::array<double, K> result{};
    double older = 0;
    for (std::size_t i = K; i-- > 1;) {
      older += weights[i];
      result[i - 1] = -older;
    }
    return result;
  }
  static constexpr auto base_weights = [] {
    std::array<double, K> weights{};
    for (std::size_t i = 0; i < K; ++i) weights[i] = -formula.alpha[i + 1] / formula.alpha[0];
    return by_differences(weights);
  }();
  /// The polynomial through K values, one step beyond: signed binomials.
  static constexpr auto guess_weights = [] {
    std::array<double, K> weights{};
    double binomial = K;
    for (std::size_t i = 0; i < K; ++i) {
      weights[i] = binomial;
      binomial *= -static_cast<double>(K - i - 1) / static_cast<double>(i + 2);
    }
    return by_differences(weights);
  }();

  Newton<P> newton_;
  StartingProcedure<OneStep, P> starting_;
  History<K, State<P>> states_;
  State<P> base_;
};

/// Base of a BDF that is started by the one-step method `Start`.
template <std::size_t K, class Start>
struct BackwardDifferenceMethod : ForAnyProblem {
  template <class P>
  using Stepper = BackwardDifferences<K, P, typename Start::template Stepper<P>>;
  static constexpr MethodInfo named(std::string_view id) {
    return {.id = id,
            .family = "multistep",
            .order = K,
            .one_step = K == 1,
            .source =
                "Curtiss, Hirschfelder 1952; Hairer, Wanner, Solving ODEs II, (V.1.19), V.2 "
                "(angles)"};
  }
};

}  // namespace odeum
