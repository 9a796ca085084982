// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "odeum/core/status.hpp"
#include "odeum/kernel/last_correction.hpp"
#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/kernel/simplified_newton.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Newton's method for y = base + gamma_h f(t, y): the equation of every diagonally implicit stage
/// and of every implicit multistep formula. The factors are kept between calls, for other stages
/// and steps, as long as gamma_h is the same and the iteration converges fast.
template <Ode P>
class NewtonIteration {
 public:
  /// `weight`: what the method multiplies the remainder of a solution by, at least 1.
  NewtonIteration(const P& problem, double weight)
      : problem_(problem),
        system_(problem),
        correction_(make_state(problem)),
        guess_(correction_),
        last_(correction_),
        increment_(correction_),
        newton_(50, 0, weight) {}

  /// From now on iterate to `fraction` of a tolerance, and fail early where convergence is too
  /// slow, since the step will be retried shorter. Without it the iteration goes on to rounding.
  void solve_to(const Tolerance& tolerance, double fraction) {
    accuracy_ = {tolerance.with_relative(tolerance.relative * fraction), correction_};
    newton_.iterate_to(1, 10);
  }

  /// On entry y is the guess, on return the solution. newton_failed where the iteration does not
  /// converge or the matrix is singular. `otherwise`: the guess from which it starts again.
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y,
               const State<P>& otherwise) {
    newton_.begin();
    last_.forget_share();
    if (gamma_h != factored_for_ && !renew(t, gamma_h, y)) return Status::newton_failed;
    guess_ = otherwise;
    for (std::size_t i = 0; i < y.size(); ++i) increment_[i] = y[i] - base[i];
    const auto correct = [&] {
      problem_.rhs(t, y.data(), correction_.data());
      for (std::size_t i = 0; i < y.size(); ++i)
        correction_[i] = gamma_h * correction_[i] - increment_[i];
      if (!system_.solve(correction_.data(), correction_accuracy)) return newton_.no_solution;
      return measure(base, y);
    };
    using enum NewtonVerdict;
    const auto take = [&](NewtonVerdict verdict) {
      if (verdict != done && (verdict == diverges || last_.share() != 1))
        return back_off(t, gamma_h, base, y) ? again : diverges;
      last_.take(correction_, y, increment_);
      return verdict;
    };
    if (newton_(correct, take, [&] { return renew(t, gamma_h, y); }) == done) return Status::ok;
    factored_for_ = 0;
    return Status::newton_failed;
  }

  /// y - base of the last solution, to its own precision.
  const State<P>& increment() const { return increment_; }

 private:
  bool renew(double t, double gamma_h, const State<P>& y) {
    newton_.renewed();
    last_.forget_share();
    system_.linearise(t, y);
    factored_for_ = system_.factorise(gamma_h) ? gamma_h : 0;
    return factored_for_ == gamma_h;
  }
  /// Where the next correction is no smaller than the last (contraction >= 1; infinite: it is not
  /// finite), or the last was taken in part. A reused Jacobian is renewed at the other guess, an
  /// older one of this solve at y; a correction by the Jacobian at its own start is halved until
  /// the next is smaller, from where the iteration goes on with a new Jacobian (Deuflhard, Newton
  /// Methods for Nonlinear Problems, 3.3). False: give up; a step that can be retried shorter does
  /// so at once.
  bool back_off(double t, double gamma_h, const State<P>& base, State<P>& y) {
    const double rate = newton_.contraction();
    const bool fresh = newton_.fresh(), finite = rate != NewtonSettings::never;
    if (fresh && (!to_rounding() || (newton_.corrections() == 0 && !finite))) return false;
    if (fresh && newton_.corrections() == 1 && !(rate <= 1 - last_.share() / 4)) {
      last_.take_share(last_.share() / 2, y, increment_);
      return true;
    }
    if (fresh && !finite) last_.take_share(0, y, increment_);
    if (!fresh) {
      y = guess_;
      for (std::size_t i = 0; i < y.size(); ++i) increment_[i] = y[i] - base[i];
    }
    return renew(t, gamma_h, y);
  }
  bool to_rounding() const { return newton_.to_rounding(); }
  /// Size of the correction; one is small enough.
  double measure(const State<P>& base, const State<P>& y) const {
    if (to_rounding()) {
      const double size = max_norm(correction_);
      if (size == 0) return 0;  // the state may be zero too
      return size / (iteration_tolerance * std::max({max_norm(y), max_norm(base), smallest_state}));
    }
    double sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double scaled = correction_[i] / accuracy_(i, std::abs(base[i]));
      sum += scaled * scaled;
    }
    return std::sqrt(sum / static_cast<double>(y.size()));
  }

  const P& problem_;
  ShiftedSystem<P> system_;
  State<P> correction_, guess_;
  LastCorrection<State<P>> last_;
  State<P> increment_;       ///< gamma_h f: rounded by itself, not as the state that it is added to
  double factored_for_ = 0;  ///< gamma_h of the factors; 0: none
  ErrorScale<State<P>> accuracy_;
  // A correction within the tolerance ends the iteration, however slowly it converges.
  SimplifiedNewton<NewtonSettings{.slow_kept = 0.05, .slow_fresh = 0.1, .most_remainder = 1}>
      newton_;
};

}  // namespace odeum
