// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <utility>

#include "odeum/core/status.hpp"
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
    for (std::size_t i = 0; i < n; ++i) {
      double q = 0, v = 0;
      for (std::size_t s = 0; s < stages; ++s) {
        q += (T.b_q[s] - T.b_q_hat[s]) * a_[s][i];
        v += (T.b_v[s] - T.b_v_hat[s]) * a_[s][i];
      }
      error[i] = h * h * q;
      error[n + i] = h * v;
    }
    move(h, y);
    return Status::ok;
  }
  void advance() {
    if constexpr (T.reuses_last_stage()) {
      std::swap(a_.front(), a_.back());
      first_known_ = true;
    }
  }
  void repeat() { first_known_ = true; }

 private:
  void evaluate(double t, double h, const State<P>& y) {
    const double* const v = y.data() + y.size() / 2;
    if (!std::exchange(first_known_, false)) problem_.acceleration(t, y.data(), v, a_[0].data());
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (evaluate_stage<I + 1>(t, h, y, std::make_index_sequence<I + 1>{}), ...);
    }
    (std::make_index_sequence<stages - 1>{});
  }

  template <std::size_t I, std::size_t... J>
  void evaluate_stage(double t, double h, const State<P>& y, std::index_sequence<J...>) {
    const std::size_t n = y.size() / 2;
    const double* const v = y.data() + n;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      ((T.a[I][J] != 0 ? void(sum += T.a[I][J] * a_[J][i]) : void()), ...);
      argument_[i] = y[i] + T.c[I] * h * v[i] + h * h * sum;
    }
    problem_.acceleration(t + T.c[I] * h, argument_.data(), v, a_[I].data());
  }

  void move(double h, State<P>& y) {
    const std::size_t n = y.size() / 2;
    for (std::size_t i = 0; i < n; ++i) {
      double q = 0, v = 0;
      for (std::size_t s = 0; s < stages; ++s) {
        q += T.b_q[s] * a_[s][i];
        v += T.b_v[s] * a_[s][i];
      }
      y[i] += h * (y[n + i] + h * q);
      y[n + i] += h * v;
    }
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
