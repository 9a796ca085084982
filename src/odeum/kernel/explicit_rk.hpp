// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <concepts>
#include <utility>

#include "odeum/core/status.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// One step of any explicit Runge-Kutta method on any problem:
///
///     k_i = f(t + c_i h, y + h sum_{j<i} a_ij k_j),   y <- y + h sum_i b_i k_i.
///
/// Stages are unrolled and zero coefficients vanish at compile time; the newest stage is added
/// last, which leaves one multiply-add between an evaluation and the next.
template <const auto& T, Ode P>
class ExplicitRungeKutta {
 public:
  static_assert(T.is_explicit());
  static constexpr std::size_t stages = T.stages;
  using Real = RealOf<P>;

  explicit ExplicitRungeKutta(const P& problem)
      : problem_(problem), argument_(make_state(problem)) {
    k_.fill(make_state(problem));
  }

  Status step(Real t, Real h, State<P>& y) {
    problem_.rhs(t, y.data(), k_[0].data());
    finish(t, h, y);
    return Status::ok;
  }

  /// The same step; `error` becomes h sum_i (b_i - b_hat_i) k_i. The first stage is not evaluated
  /// where the call before, advance() or repeat(), knows it.
  Status step(Real t, Real h, State<P>& y, State<P>& error) requires(T.embedded()) {
    if (!first_known_) problem_.rhs(t, y.data(), k_[0].data());
    first_known_ = false;
    finish(t, h, y);
    if constexpr (T.first_same_as_last())
      problem_.rhs(t + T.c(stages - 1) * h, y.data(), k_.back().data());
    const auto weights = times<estimate_row>(h);
    each_component(y, [&](std::size_t n) { error[n] = weighted<estimate_row>(weights, k_, n); });
    return Status::ok;
  }
  /// The last step was accepted: the next one, of any length, starts at its end. The last stage of
  /// a first-same-as-last tableau is reused as the first.
  void advance() {
    if constexpr (T.first_same_as_last()) {
      exchange_components(k_.front(), k_.back());
      first_known_ = true;
    }
  }
  /// The last step was rejected: the next one starts from the same state.
  void repeat() { first_known_ = true; }
  /// The state was changed after the last step.
  void forget() { first_known_ = false; }

  /// h sum_i row_i k_i over the stages of the last step, before advance(): another row's estimate,
  /// or the term that an interpolant adds to Hermite's (dense_output.hpp).
  template <const auto& weights>
  void weighted_sum(Real h, State<P>& sum) const {
    const auto scaled = times<weights>(h);
    each_component(sum, [&](std::size_t n) { sum[n] = weighted<weights>(scaled, k_, n); });
  }
  /// f at the start of the last step, and (first same as last) at its end; before advance().
  const State<P>& first_stage() const { return k_.front(); }
  State<P>& first_stage() { return k_.front(); }
  const State<P>& last_stage() const { return k_.back(); }

 private:
  static constexpr auto main_row = T.b, estimate_row = T.difference();

  /// The stages after the first and the new state, at which the last stage of a first-same-as-last
  /// tableau is evaluated: only an estimate of the error or the next step has a use for that one.
  [[gnu::always_inline]] void finish(Real t, Real h, State<P>& y) {
    constexpr std::size_t inner = T.first_same_as_last() ? stages - 2 : stages - 1;
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      (evaluate_stage<I + 1>(t, h, y, std::make_index_sequence<I + 1>{}), ...);
    }
    (std::make_index_sequence<inner>{});
    const auto weights = times<main_row>(h);
    each_component(y, [&](std::size_t n) {
      y[n] = (y[n] + weighted<older_row>(weights, k_, n)) + weights[newest] * k_[newest][n];
    });
  }

  template <std::size_t I, std::size_t... J>
  [[gnu::always_inline]] void evaluate_stage(Real t, Real h, const State<P>& y,
                                             std::index_sequence<J...>) {
    const std::array<Real, I> ha{static_cast<Real>(h * T.a[I][J])...};
    each_component(y, [&](std::size_t n) {
      Real sum = y[n];
      ((T.a[I][J] != 0 ? void(sum += ha[J] * k_[J][n]) : void()), ...);
      argument_[n] = sum;
    });
    problem_.rhs(static_cast<Real>(t + T.c(I) * h), argument_.data(), k_[I].data());
  }

  template <const auto& row>
  static constexpr std::array<Real, stages> times(Real h) {
    std::array<Real, stages> weights{};
    for (std::size_t i = 0; i < stages; ++i) weights[i] = static_cast<Real>(h * row[i]);
    return weights;
  }

  /// The last stage with a nonzero weight.
  static constexpr std::size_t newest = [] {
    std::size_t i = stages - 1;
    while (i > 0 && T.b[i] == 0) --i;
    return i;
  }();
  // The increment of the others is summed before it is added to y, so that y is rounded once per
  // sum and not once per stage.
  static constexpr auto older_row = [] {
    auto row = T.b;
    row[newest] = 0;
    return row;
  }();

  const P& problem_;
  std::array<State<P>, stages> k_;
  State<P> argument_;
  bool first_known_ = false;  ///< k_[0] is f at the start of the step to come
};

/// Base of a method that is an explicit tableau and nothing else.
template <const auto& T>
struct ExplicitRungeKuttaMethod : TableauMethod<T> {
  template <class P>
  using Stepper = ExplicitRungeKutta<T, P>;
  static constexpr MethodInfo described(MethodInfo info) {
    return completed(info, "explicit_rk", T);
  }
};

/// A method that is an explicit tableau and nothing else.
template <class M>
concept ExplicitTableauMethod = requires {
  M::tableau;
  requires std::derived_from<M, ExplicitRungeKuttaMethod<M::tableau>>;
};

}  // namespace odeum
