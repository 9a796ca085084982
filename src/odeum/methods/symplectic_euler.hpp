// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Symplectic Euler, velocity first:
///
///     v_{n+1} = v_n + h a(t_n, q_n, v_n),   q_{n+1} = q_n + h v_{n+1}.
///
/// Symplectic where a does not depend on v; of order 1 with damping too.
struct symplectic_euler : ForSecondOrder {
  static constexpr MethodInfo info{
      .id = "symplectic_euler",
      .family = "symplectic",
      .order = 1,
      .common_use = CommonUse::engine,
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
      problem_.acceleration(t, q, v, a_.data());
      for (std::size_t i = 0; i < n; ++i) {
        v[i] += h * a_[i];
        q[i] += h * v[i];
      }
      return Status::ok;
    }

   private:
    const P& problem_;
    State<P> a_;
  };

  static OscillatorMap oscillator_map(double w) { return {1 - w * w, w, -w, 1}; }
};

}  // namespace odeum::methods
