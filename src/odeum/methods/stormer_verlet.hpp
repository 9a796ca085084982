// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Stormer-Verlet on positions only:
///
///     q_{n+1} = 2 q_n - q_{n-1} + h^2 a(t_n, q_n),   q_1 = q_0 + h v_0 + h^2/2 a_0.
///
/// The velocity reported is the central difference (q_{n+1} - q_{n-1}) / 2h. Its rounding error
/// grows like epsilon |q| / h^2 over a run: the scheme adds h^2 a to numbers of the size of q.
struct stormer_verlet : ForSeparable {
  static constexpr MethodInfo info{.id = "stormer_verlet",
                                   .family = "symplectic",
                                   .order = 2,
                                   .one_step = false,
                                   .source =
                                       "Verlet, Phys. Rev. 159 (1967) 98, (4); Hairer, Lubich, "
                                       "Wanner, Acta Numerica 12 (2003) 399"};

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem)
        : problem_(problem), a_(make_state(problem)), previous_(a_), next_(a_) {}

    void start(double t, double h, const State<P>& y) {
      const std::size_t n = y.size() / 2;
      problem_.acceleration(t, y.data(), y.data() + n, a_.data());
      for (std::size_t i = 0; i < n; ++i) next_[i] = y[i] + h * (y[n + i] + h / 2 * a_[i]);
    }

    Status step(double t, double h, State<P>& y) {
      const std::size_t n = y.size() / 2;
      for (std::size_t i = 0; i < n; ++i) {
        previous_[i] = y[i];
        y[i] = next_[i];
      }
      problem_.acceleration(t + h, y.data(), y.data() + n, a_.data());
      for (std::size_t i = 0; i < n; ++i) {
        next_[i] = 2 * y[i] - previous_[i] + h * h * a_[i];
        y[n + i] = (next_[i] - previous_[i]) / (2 * h);
      }
      return Status::ok;
    }

   private:
    const P& problem_;
    State<P> a_, previous_, next_;
  };

  /// The map between reported states is that of velocity Verlet.
  static OscillatorMap oscillator_map(double w) {
    return {1 - w * w / 2, w, -w * (1 - w * w / 4), 1 - w * w / 2};
  }
};

}  // namespace odeum::methods
