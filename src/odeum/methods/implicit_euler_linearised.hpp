// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <complex>

#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/linear/shifted_solver.hpp"

namespace odeum::methods {

/// Implicit Euler with one linear solve a step, (I - h J) dy = h f(t_{n+1}, y_n). For a mechanical
/// system y = (x, v), with dx = h (v + dv) eliminated, it is Baraff and Witkin's
///
///     (I - h M^-1 df/dv - h^2 M^-1 df/dx) dv = h M^-1 (f + h df/dx v),
///
/// the form in which the shifted solver of a second-order problem solves it. Explicit time enters
/// as f(t + h, y) = f(t, y) + h f_t + O(h^2), so that df/dt is not needed.
struct implicit_euler_linearised : ForAnyProblem {
  static constexpr MethodInfo info{
      .id = "implicit_euler_linearised",
      .family = "linearly_implicit",
      .order = 1,
      .common_use = CommonUse::engine,
      .source = "Baraff, Witkin, SIGGRAPH 1998, (6); Hairer, Wanner, Solving ODEs II, IV.9 (9.1)"};

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem)
        : problem_(problem), shifted_(make_shifted_solver(problem)), dy_(make_state(problem)) {}

    Status step(double t, double h, State<P>& y) {
      if (!shifted_->factorise(t + h, y.data(), h)) return Status::newton_failed;
      problem_.rhs(t + h, y.data(), dy_.data());
      for (double& component : dy_) component *= h;
      if (!shifted_->solve(dy_.data(), ShiftedSolver::exact)) return Status::newton_failed;
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += dy_[i];
      return Status::ok;
    }

   private:
    const P& problem_;
    ShiftedSolverOf<P> shifted_;
    State<P> dy_;
  };

  static double amplification(double re, double im) {
    return 1 / std::abs(1.0 - std::complex<double>(re, im));
  }
};

}  // namespace odeum::methods
