// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/core/status.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Convergence threshold of Newton and fixed-point corrections, relative to the largest component
/// of the state: far below the truncation errors that a study resolves, and far enough above
/// rounding to be reached.
inline constexpr double iteration_tolerance = 1e-13;
/// Corrections to a state smaller than this are measured against it: subnormal numbers have no
/// digits left to converge in.
inline constexpr double smallest_state = 1e15 * std::numeric_limits<double>::min();

/// Relative residual of Newton's linear systems: the next correction removes the rest, and it is
/// far below the contraction that the iteration accepts.
inline constexpr double correction_accuracy = 1e-8;

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

/// Newton's method for y = base + gamma_h f(t, y): the equation of every diagonally implicit stage
/// and of every implicit multistep formula. The factors are kept between calls, for other stages
/// and steps, as long as gamma_h is the same and the iteration converges fast; slow convergence
/// triggers a new Jacobian (Hairer, Wanner, Solving ODEs II, IV.8).
template <Ode P>
class Newton {
 public:
  explicit Newton(const P& problem)
      : problem_(problem),
        system_(problem),
        correction_(make_state(problem)),
        guess_(correction_) {}

  /// From now on iterate to `fraction` of a tolerance (relative and absolute, the same number), and
  /// fail early where convergence is too slow, since the step will be retried shorter. Without it
  /// the iteration goes on to rounding.
  void solve_to(double tolerance, double fraction) {
    accuracy_ = tolerance * fraction;
    max_iterations_ = 10;
  }

  /// On entry y is the guess, on return the solution. newton_failed where the iteration does not
  /// converge or the matrix is singular.
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y) {
    bool fresh = false;
    if (gamma_h != factored_for_ && !renew(t, gamma_h, y, fresh)) return Status::newton_failed;
    guess_ = y;
    double last = 0;
    int since_renewal = 0;
    for (int iteration = 0; iteration < max_iterations_; ++iteration) {
      problem_.rhs(t, y.data(), correction_.data());
      for (std::size_t i = 0; i < y.size(); ++i)
        correction_[i] = base[i] + gamma_h * correction_[i] - y[i];
      if (!system_.solve(correction_.data(), correction_accuracy)) return fail();
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += correction_[i];
      const double size = measure(base, y);
      if (size <= 1) return Status::ok;
      const double rate = since_renewal > 0 ? size / last : 0;
      if (since_renewal > 0 && rate < 1 && size * rate / (1 - rate) <= safety()) return Status::ok;
      const bool slow = since_renewal > 0 && rate > (fresh ? slow_fresh : slow_kept);
      if (!std::isfinite(size) || rate >= 1) {
        // Not finite or diverging: if the Jacobian was a reused one, restart from the guess.
        if (fresh && (accuracy_ > 0 || !std::isfinite(size))) return fail();
        if (!fresh) y = guess_;
      }
      if (slow || !std::isfinite(size)) {
        if (!renew(t, gamma_h, y, fresh)) return Status::newton_failed;
        since_renewal = 0;
      } else {
        ++since_renewal;
      }
      last = size;
    }
    return fail();
  }

 private:
  // A contraction above this triggers a new Jacobian: earlier for a reused one, since the next
  // steps profit too.
  static constexpr double slow_kept = 0.05, slow_fresh = 0.1;

  bool renew(double t, double gamma_h, const State<P>& y, bool& fresh) {
    fresh = true;
    system_.linearise(t, y);
    factored_for_ = system_.factorise(gamma_h) ? gamma_h : 0;
    return factored_for_ == gamma_h;
  }
  Status fail() {
    factored_for_ = 0;
    return Status::newton_failed;
  }
  /// Bound on the predicted remainder; smaller at rounding, where no later check follows.
  double safety() const { return accuracy_ > 0 ? 1 : 0.01; }

  /// Size of the correction; one is small enough.
  double measure(const State<P>& base, const State<P>& y) const {
    if (accuracy_ == 0) {
      const double size = max_norm(correction_);
      if (size == 0) return 0;  // the state may be zero too
      return size / (iteration_tolerance * std::max({max_norm(y), max_norm(base), smallest_state}));
    }
    double sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double scaled = correction_[i] / (accuracy_ * (1 + std::abs(base[i])));
      sum += scaled * scaled;
    }
    return std::sqrt(sum / static_cast<double>(y.size()));
  }

  const P& problem_;
  ShiftedSystem<P> system_;
  State<P> correction_, guess_;
  double factored_for_ = 0;  ///< gamma_h of the factors; 0: none
  double accuracy_ = 0;
  int max_iterations_ = 50;
};

}  // namespace odeum
