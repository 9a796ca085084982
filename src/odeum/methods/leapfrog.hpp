// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Leapfrog, velocities at half steps, started with half an Euler step:
///
///     v_{1/2} = v_0 + h/2 a_0,
///     q_{n+1} = q_n + h v_{n+1/2},   v_{n+3/2} = v_{n+1/2} + h a_{n+1}.
///
/// The velocity reported at t_{n+1} is v_{n+3/2} - h/2 a_{n+1}.
struct leapfrog : ForSeparable {
  static constexpr MethodInfo info{
      .id = "leapfrog",
      .family = "symplectic",
      .order = 2,
      .one_step = false,
      .source = "Hairer, Lubich, Wanner, Geometric Numerical Integration, (I.1.17)"};

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem) : problem_(problem), a_(make_state(problem)), v_half_(a_) {}

    void start(double t, double h, const State<P>& y) {
      const std::size_t n = y.size() / 2;
      problem_.acceleration(t, y.data(), y.data() + n, a_.data());
      for (std::size_t i = 0; i < n; ++i) v_half_[i] = y[n + i] + h / 2 * a_[i];
    }

    Status step(double t, double h, State<P>& y) {
      const std::size_t n = y.size() / 2;
      for (std::size_t i = 0; i < n; ++i) y[i] += h * v_half_[i];
      problem_.acceleration(t + h, y.data(), y.data() + n, a_.data());
      for (std::size_t i = 0; i < n; ++i) {
        v_half_[i] += h * a_[i];
        y[n + i] = v_half_[i] - h / 2 * a_[i];
      }
      return Status::ok;
    }

   private:
    const P& problem_;
    State<P> a_, v_half_;
  };

  /// The map between reported states is that of velocity Verlet.
  static OscillatorMap oscillator_map(double w) {
    return {1 - w * w / 2, w, -w * (1 - w * w / 4), 1 - w * w / 2};
  }
};

}  // namespace odeum::methods
