// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <utility>

#include "odeum/core/status.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/tableau/nystroem.hpp"

namespace odeum {

/// One step of an explicit Runge-Kutta-Nystroem method, see tableau/nystroem.hpp. Stages are
/// unrolled and zero coefficients vanish. advance() and repeat() as in explicit_rk.hpp.
template <const auto& T, class P>
class NystroemStepper {
 public:
  static constexpr std::size_t stages = T.stages;

  explicit NystroemStepper(const P& problem) : problem_(problem), argument_(make_state(problem)) {
    a_.fill(make_state(problem));
  }

  Status step(double t, double h, State<P>& y) {
    first_known_ = false;
    evaluate(t, h, y);
    move(h, y);
    return Status::ok;
  }

  /// The same step; `error` is what the embedded rows differ by, positions and velocities.
  Status step(double t, double h, State<P>& y, State<P>& error) requires(T.has_embedded_rows()) {
    evaluate(t, h, y);
    const std::size_t n = y.size() / 2;
    each_degree(n, [&](std::size_t i) {
      error[i] = h * h * weighted<error_q>(error_q, a_, i);
      error[n + i] = h * weighted<error_v>(error_v, a_, i);
    });
    move(h, y);
    return Status::ok;
  }
  void advance() {
    if constexpr (T.reuses_last_stage()) {
      exchange_components(a_.front(), a_.back());
      first_known_ = true;
    }
  }
  void repeat() { first_known_ = true; }

 private:
  static constexpr auto b_q = T.b_q, b_v = T.b_v;
  static constexpr auto difference = [](auto row, const auto& hat) {
    for (std::size_t s = 0; s < stages; ++s) row[s] -= hat[s];
    return row;
  };
  static constexpr auto error_q = difference(T.b_q, T.b_q_hat);
  static constexpr auto error_v = difference(T.b_v, T.b_v_hat);

  template <class F>
  [[gnu::always_inline]] static void each_degree(std::size_t n, F&& f) {
    each_of<static_size<State<P>> / 2>(n, f);
  }
  [[gnu::always_inline]] void evaluate(double t, double h, const State<P>& y) {
    const double* const v = y.data() + y.size() / 2;
    if (!std::exchange(first_known_, false)) problem_.acceleration(t, y.data(), v, a_[0].data());
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      (evaluate_stage<I + 1>(t, h, y, std::make_index_sequence<I + 1>{}), ...);
    }
    (std::make_index_sequence<stages - 1>{});
  }

  /// The newest stage is added last, as in explicit_rk.hpp.
  template <std::size_t I, std::size_t... J>
  [[gnu::always_inline]] void evaluate_stage(double t, double h, const State<P>& y,
                                             std::index_sequence<J...>) {
    const std::size_t n = y.size() / 2;
    const double* const v = y.data() + n;
    const std::array<double, I> weights{h * h * T.a[I][J]...};
    each_degree(n, [&](std::size_t i) {
      double argument = y[i] + T.c[I] * h * v[i];
      ((T.a[I][J] != 0 ? void(argument += weights[J] * a_[J][i]) : void()), ...);
      argument_[i] = argument;
    });
    problem_.acceleration(t + T.c[I] * h, argument_.data(), v, a_[I].data());
  }

  [[gnu::always_inline]] void move(double h, State<P>& y) {
    const std::size_t n = y.size() / 2;
    each_degree(n, [&](std::size_t i) {
      y[i] += h * (y[n + i] + h * weighted<b_q>(b_q, a_, i));
      y[n + i] += h * weighted<b_v>(b_v, a_, i);
    });
  }

  const P& problem_;
  std::array<State<P>, stages> a_;
  State<P> argument_;
  bool first_known_ = false;
};

/// Base of a method that is a Nystroem tableau and nothing else.
template <const auto& T>
struct NystroemMethod : ForSeparable {
  static constexpr const auto& nystroem = T;
  template <class P>
  using Stepper = NystroemStepper<T, P>;
  static constexpr MethodInfo described(MethodInfo info) { return completed(info, "nystroem", T); }

  static OscillatorMap oscillator_map(double w) {
    OscillatorMap m{};
    for (std::size_t column : {0, 1}) {
      const double x = column == 0, u = column == 1;  // x = w q
      std::array<double, T.stages> g{};
      double end_x = x + w * u, end_u = u;
      for (std::size_t i = 0; i < T.stages; ++i) {
        g[i] = x + T.c[i] * w * u;
        for (std::size_t j = 0; j < i; ++j) g[i] -= w * w * T.a[i][j] * g[j];
        end_x -= w * w * T.b_q[i] * g[i];
        end_u -= w * T.b_v[i] * g[i];
      }
      m[column] = end_x;
      m[2 + column] = end_u;
    }
    return m;
  }
};

}  // namespace odeum
