// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <utility>

#include "odeum/kernel/newton.hpp"
#include "odeum/tableau/multistep_coefficients.hpp"

namespace odeum {

/// The last `Depth` states or slopes of a run, newest first.
template <std::size_t Depth, class S>
class History {
 public:
  explicit History(const S& zero) { entries_.fill(zero); }
  /// Room for the next newest entry, which the caller fills.
  S& push() {
    newest_ = (newest_ + Depth - 1) % Depth;
    if (count_ < Depth) ++count_;
    return entries_[newest_];
  }
  const S& operator[](std::size_t age) const { return entries_[(newest_ + age) % Depth]; }
  bool full() const { return count_ == Depth; }
  void clear() { count_ = 0; }

 private:
  std::array<S, Depth> entries_;
  std::size_t newest_ = 0, count_ = 0;
};

/// Starting values of a multistep method, by substeps of a one-step method whose order is the
/// multistep method's or one less: its local error is then of the right order, and the substeps
/// keep it below the errors of the steps that follow.
template <class OneStep, Ode P>
class StartingProcedure {
 public:
  explicit StartingProcedure(const P& problem) : one_step_(problem) {}
  Status advance(double t, double h, State<P>& y) {
    constexpr int substeps = 4;
    for (int i = 0; i < substeps; ++i) {
      const Status status = one_step_.step(t + i * (h / substeps), h / substeps, y);
      if (status != Status::ok) return status;
    }
    return Status::ok;
  }

 private:
  OneStep one_step_;
};

/// Adams-Bashforth of order K at a fixed step: y_{n+1} = y_n + h sum_i beta_i f_{n-i}. With
/// `Correct` its result is a prediction, evaluated and corrected by Adams-Moulton of the same order
/// (PECE; the last evaluation is the next step's first).
template <std::size_t K, bool Correct, Ode P, class OneStep>
class Adams {
 public:
  explicit Adams(const P& problem)
      : problem_(problem),
        starting_(problem),
        slopes_(make_state(problem)),
        predicted_(make_state(problem)),
        f_predicted_(predicted_) {}

  void start(double, double, const State<P>&) { slopes_.clear(); }

  Status step(double t, double h, State<P>& y) {
    problem_.rhs(t, y.data(), slopes_.push().data());
    if (!slopes_.full()) return starting_.advance(t, h, y);
    for (std::size_t n = 0; n < y.size(); ++n) {
      double sum = 0;
      for (std::size_t i = 0; i < K; ++i) sum += bashforth.beta[i + 1] * slopes_[i][n];
      predicted_[n] = y[n] + h * sum;
    }
    if constexpr (!Correct) {
      y = predicted_;
    } else {
      problem_.rhs(t + h, predicted_.data(), f_predicted_.data());
      for (std::size_t n = 0; n < y.size(); ++n) {
        double sum = moulton.beta[0] * f_predicted_[n];
        for (std::size_t i = 0; i + 1 < K; ++i) sum += moulton.beta[i + 1] * slopes_[i][n];
        y[n] += h * sum;
      }
    }
    return Status::ok;
  }

 private:
  static constexpr auto bashforth = adams_bashforth_coefficients<K>();
  static constexpr auto moulton = adams_moulton_coefficients<(K > 1 ? K - 1 : 1)>();
  static_assert(multistep_proven(bashforth, K));
  static_assert(!Correct || multistep_proven(moulton, K));

  const P& problem_;
  StartingProcedure<OneStep, P> starting_;
  History<K, State<P>> slopes_;
  State<P> predicted_, f_predicted_;
};

/// BDF of order K at a fixed step, by Newton's method from the polynomial through the last K
/// states. Formula and guess are summed from the newest state and the differences of neighbours,
/// which are small and exact, so that the alphas do not amplify rounding.
template <std::size_t K, Ode P, class OneStep>
class BackwardDifferences {
 public:
  explicit BackwardDifferences(const P& problem)
      : newton_(problem),
        starting_(problem),
        states_(make_state(problem)),
        base_(make_state(problem)) {}

  void start(double, double, const State<P>&) { states_.clear(); }

  Status step(double t, double h, State<P>& y) {
    states_.push() = y;
    if (!states_.full()) return starting_.advance(t, h, y);
    for (std::size_t n = 0; n < y.size(); ++n) {
      double sum = 0, guess = 0;
      for (std::size_t i = K - 1; i-- > 0;) {
        const double difference = states_[i][n] - states_[i + 1][n];
        sum += base_weights[i] * difference;
        guess += guess_weights[i] * difference;
      }
      base_[n] = states_[0][n] + sum;
      y[n] = states_[0][n] + guess;
    }
    return newton_.solve(t + h, h / formula.alpha[0], base_, y);
  }

 private:
  static constexpr auto formula = backward_difference_coefficients<K>();
  static_assert(multistep_proven(formula, K));
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

}  // namespace odeum
