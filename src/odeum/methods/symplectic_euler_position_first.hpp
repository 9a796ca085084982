// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Symplectic Euler, position first, the adjoint of the velocity-first form for a = a(q):
///
///     q_{n+1} = q_n + h v_n,   v_{n+1} = v_n + h a(t_{n+1}, q_{n+1}, v_n).
struct symplectic_euler_position_first : ForSecondOrder {
  static constexpr MethodInfo info{
      .id = "symplectic_euler_position_first",
      .family = "symplectic",
      .order = 1,
      .source =
          "de Vogelaere 1956; Hairer, Lubich, Wanner, Geometric Numerical Integration, (I.1.9)"};

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem) : problem_(problem), a_(make_state(problem)) {}

    Status step(double t, double h, State<P>& y) {
      const std::size_t n = y.size() / 2;
      double* const q = y.data();
      double* const v = q + n;
      for (std::size_t i = 0; i < n; ++i) q[i] += h * v[i];
      problem_.acceleration(t + h, q, v, a_.data());
      for (std::size_t i = 0; i < n; ++i) v[i] += h * a_[i];
      return Status::ok;
    }

   private:
    const P& problem_;
    State<P> a_;
  };

  static OscillatorMap oscillator_map(double w) { return {1, w, -w, 1 - w * w}; }
};

}  // namespace odeum::methods
