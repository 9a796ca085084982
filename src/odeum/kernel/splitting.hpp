// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>

#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/tableau/splitting.hpp"

namespace odeum {

/// One step of a symplectic splitting of q'' = a(t, q), see tableau/splitting.hpp. Each kick
/// evaluates a at the time reached by the drifts before it. Unrolled; zero coefficients vanish.
template <const auto& C, class P>
class SplittingStepper {
 public:
  explicit SplittingStepper(const P& problem) : problem_(problem), a_(make_state(problem)) {}

  void start(double t, double /*h*/, const State<P>& y) requires(C.reuses_last_stage()) {
    problem_.acceleration(t, y.data(), y.data() + y.size() / 2, a_.data());
  }

  Status step(double t, double h, State<P>& y) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (turn<I>(t, h, y), ...); }
    (std::make_index_sequence<C.stages>{});
    return Status::ok;
  }

 private:
  template <std::size_t I>
  void turn(double t, double h, State<P>& y) {
    const std::size_t n = y.size() / 2;
    double* const q = y.data();
    double* const v = q + n;
    if constexpr (C.kick[I] != 0) {
      constexpr bool at_end = I + 1 == C.stages && C.drift[I] == 0;
      if constexpr (I != 0 || !C.reuses_last_stage())
        problem_.acceleration(t + (at_end ? 1 : C.c(I)) * h, q, v, a_.data());
      for (std::size_t i = 0; i < n; ++i) v[i] += h * C.kick[I] * a_[i];
    }
    if constexpr (C.drift[I] != 0)
      for (std::size_t i = 0; i < n; ++i) q[i] += h * C.drift[I] * v[i];
  }

  const P& problem_;
  State<P> a_;
};

/// Base of a method that is a splitting and nothing else.
template <const auto& C>
struct SplittingMethod : ForSeparable {
  static constexpr const auto& splitting = C;
  template <class P>
  using Stepper = SplittingStepper<C, P>;
  static constexpr MethodInfo described(MethodInfo info) {
    return completed(info, "symplectic", C);
  }

  static OscillatorMap oscillator_map(double w) {
    OscillatorMap m{1, 0, 0, 1};
    for (std::size_t i = 0; i < C.stages; ++i) {
      for (std::size_t column : {0, 1}) {
        m[2 + column] -= w * C.kick[i] * m[column];
        m[column] += w * C.drift[i] * m[2 + column];
      }
    }
    return m;
  }
};

}  // namespace odeum
