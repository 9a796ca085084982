// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Velocity Verlet:
///
///     q_{n+1} = q_n + h v_n + h^2/2 a_n,   v_{n+1} = v_n + h/2 (a_n + a_{n+1}).
///
/// Where a depends on the velocity, a_{n+1} is taken at the predicted velocity v_n + h a_n, which
/// keeps order 2 (the velocity at the half step, often used there, lowers it to 1). One evaluation
/// per step: a_{n+1} is reused by the next one.
struct velocity_verlet : ForSecondOrder {
  static constexpr MethodInfo info{
      .id = "velocity_verlet",
      .family = "symplectic",
      .order = 2,
      .common_use = CommonUse::engine,
      .source = "Swope, Andersen, Berens, Wilson, J. Chem. Phys. 76 (1982) 637, (4)-(6)"};
  static constexpr auto inlined = Inlined::nonstiff;

  template <class P>
  class Stepper {
   public:
    using Real = RealOf<P>;

    explicit Stepper(const P& problem)
        : problem_(problem), a_(make_state(problem)), a_next_(a_), predicted_(a_) {}

    void start(Real t, Real /*h*/, const State<P>& y) {
      problem_.acceleration(t, y.data(), y.data() + y.size() / 2, a_.data());
    }

    Status step(Real t, Real h, State<P>& y) {
      const std::size_t n = y.size() / 2;
      Real *const q = y.data(), *const v = q + n;
      for (std::size_t i = 0; i < n; ++i) {
        q[i] += h * (v[i] + h / 2 * a_[i]);
        predicted_[i] = v[i] + h * a_[i];
      }
      problem_.acceleration(t + h, q, predicted_.data(), a_next_.data());
      for (std::size_t i = 0; i < n; ++i) v[i] += h / 2 * (a_[i] + a_next_[i]);
      std::swap(a_, a_next_);
      return Status::ok;
    }

   private:
    const P& problem_;
    State<P> a_, a_next_, predicted_;
  };

  static OscillatorMap oscillator_map(double w) {
    return {1 - w * w / 2, w, -w * (1 - w * w / 4), 1 - w * w / 2};
  }
};

}  // namespace odeum::methods
