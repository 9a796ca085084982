// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/bounded_steps.hpp"
#include "odeum/kernel/newton_iteration.hpp"

namespace odeum {

/// Newton's method, and where that fails at a step that is not retried shorter: Newton's method
/// from a state that steps with a bound of the Jacobian lead to.
template <Ode P>
class Newton {
 public:
  /// `weight`: what the method multiplies the remainder of a solution by, at least 1.
  explicit Newton(const P& problem, double weight = 1)
      : problem_(problem), iteration_(problem, weight) {}

  /// A step that fails will be repeated shorter, which is cheaper than steps with a bound.
  void will_be_retried() { retried_ = true; }
  /// See NewtonIteration.
  void solve_to(const Tolerance& tolerance, double fraction) {
    will_be_retried();
    iteration_.solve_to(tolerance, fraction);
  }
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y,
               const State<P>& otherwise) {
    Status status = iteration_.solve(t, gamma_h, base, y, otherwise);
    if (status == Status::ok || retried_) return status;
    constexpr int most_steps = 640;
    State<P> closer = otherwise;
    for (int count = 10; count <= most_steps && status != Status::ok; count *= 2) {
      if (!bounded_steps(problem_, t, gamma_h, base, closer, count)) break;
      y = closer;
      status = iteration_.solve(t, gamma_h, base, y, closer);
    }
    return status;
  }
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y) {
    const State<P> otherwise = y;
    return solve(t, gamma_h, base, y, otherwise);
  }
  const State<P>& increment() const { return iteration_.increment(); }

 private:
  const P& problem_;
  NewtonIteration<P> iteration_;
  bool retried_ = false;
};

}  // namespace odeum
