// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <limits>

#include "odeum/kernel/method.hpp"
#include "odeum/kernel/newton.hpp"

namespace odeum::methods {

/// Implicit Euler solved by fixed-point iteration y <- y_n + h f(t_{n+1}, y), which contracts only
/// where h times the Lipschitz constant of f is below one: implicit, yet with the step limit of an
/// explicit method. newton_failed after `max_iterations`.
struct implicit_euler_fixed_point : ForAnyProblem {
  static constexpr int max_iterations = 200;
  /// Converged where the correction is below this, relative to the state. It is 1e5 times the
  /// rounding that a difference of states carries, so that the largest step follows from
  /// contraction and not from rounding.
  static constexpr double correction_tolerance = 1e-11;
  static constexpr MethodInfo info{
      .id = "implicit_euler_fixed_point",
      .family = "functional_iteration",
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
        if (change <= correction_tolerance * std::max(max_norm(y), max_norm(y_next_))) {
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

  /// |R(z)| of the truncated iteration; NaN where it does not converge. On y' = z y correction k is
  /// z^k y_n, and the iterate is the geometric sum 1 + z + ... + z^k times y_n.
  static double amplification(double re, double im) {
    const std::complex<double> z(re, im);
    std::complex<double> power = 1, sum = 1;
    for (int k = 1; k <= max_iterations; ++k) {
      power *= z;
      sum += power;
      if (std::abs(power) <= correction_tolerance * std::max(1.0, std::abs(sum)))
        return std::abs(sum);
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace odeum::methods
