// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/newton.hpp"

namespace odeum::methods {

/// Implicit Euler solved by fixed-point iteration y <- y_n + h f(t_{n+1}, y), which contracts only
/// where h times the Lipschitz constant of f is below one: implicit, yet with an explicit method's
/// step limit. Gives up after `max_iterations`.
struct implicit_euler_fixed_point : ForAnyProblem {
  static constexpr int max_iterations = 200;
  static constexpr MethodInfo info{
      .id = "implicit_euler_fixed_point",
      .family = "implicit_rk",
      .order = 1,
      .source = "Hairer, Norsett, Wanner, Solving ODEs I, (II.7.5); Solving ODEs II, IV.8"};

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem) : problem_(problem), f_(make_state(problem)), y_next_(f_) {}

    Status step(double t, double h, State<P>& y) {
      y_next_ = y;
      for (int iteration = 0; iteration < max_iterations; ++iteration) {
        problem_.rhs(t + h, y_next_.data(), f_.data());
        for (std::size_t i = 0; i < y.size(); ++i) {
          const double next = y[i] + h * f_[i];
          f_[i] = next - y_next_[i];
          y_next_[i] = next;
        }
        const double change = max_norm(f_);
        if (!std::isfinite(change)) return Status::newton_failed;
        if (change <= iteration_tolerance * std::max(max_norm(y), max_norm(y_next_))) {
          y = y_next_;
          return Status::ok;
        }
      }
      return Status::newton_failed;
    }

   private:
    const P& problem_;
    State<P> f_, y_next_;
  };
};

}  // namespace odeum::methods
