// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "odeum/harness/outcome.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// The size that a Newton or fixed-point correction must fall under, relative to the largest
/// component of the state: far below any truncation error that a study resolves, far enough above
/// rounding to be reached.
inline constexpr double iteration_tolerance = 1e-13;

/// The largest modulus of the components; NaN where one is NaN.
template <class S>
double max_norm(const S& x) {
  double norm = 0;
  for (const double component : x) {
    if (std::isnan(component)) return component;
    norm = std::max(norm, std::abs(component));
  }
  return norm;
}

/// Newton's method for y = base + gamma_h f(t, y): the equation of every diagonally implicit stage.
/// The Jacobian is taken at the first iterate and again whenever convergence is slow.
template <Ode P>
class Newton {
 public:
  explicit Newton(const P& problem)
      : problem_(problem),
        shifted_(make_shifted_solver(problem)),
        f_(make_state(problem)),
        correction_(f_) {}

  /// On entry y is the guess, on return the solution. newton_failed after `max_iterations`.
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y) {
    constexpr int max_iterations = 50;
    constexpr double slow = 0.1;  // a contraction worse than this earns a new Jacobian
    double last = 0;
    bool fresh_jacobian_wanted = true;
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
      if (fresh_jacobian_wanted && !shifted_->factorise(t, y.data(), gamma_h))
        return Status::newton_failed;
      problem_.rhs(t, y.data(), f_.data());
      for (std::size_t i = 0; i < y.size(); ++i) correction_[i] = base[i] + gamma_h * f_[i] - y[i];
      if (!shifted_->solve(correction_.data())) return Status::newton_failed;
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += correction_[i];
      const double size = max_norm(correction_);
      if (!std::isfinite(size)) return Status::newton_failed;
      if (size <= iteration_tolerance * std::max(max_norm(y), max_norm(base))) return Status::ok;
      fresh_jacobian_wanted = iteration > 0 && size > slow * last;
      last = size;
    }
    return Status::newton_failed;
  }

 private:
  const P& problem_;
  ShiftedSolverOf<P> shifted_;
  State<P> f_, correction_;
};

}  // namespace odeum
