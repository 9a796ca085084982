// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "odeum/core/status.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/iteration.hpp"
#include "odeum/kernel/last_correction.hpp"
#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/kernel/simplified_newton.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Newton's method for y = base + gamma_h f(t, y): the equation of every diagonally implicit stage
/// and of every implicit multistep formula. The factors are kept between calls, for other stages
/// and steps, as long as gamma_h is the same and the iteration converges fast; slow convergence
/// triggers a new Jacobian (Hairer, Wanner, Solving ODEs II, IV.8).
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
        newton_(max_iterations_, 0, weight) {}

  /// From now on iterate to `fraction` of a tolerance, and fail early where convergence is too
  /// slow, since the step will be retried shorter. Without it the iteration goes on to rounding.
  void solve_to(const Tolerance& tolerance, double fraction) {
    accuracy_ = {tolerance.with_relative(tolerance.relative * fraction), correction_};
    max_iterations_ = 10;
    newton_ = Convergence(max_iterations_, 1);
  }

  /// On entry y is the guess, on return the solution. newton_failed where the iteration does not
  /// converge or the matrix is singular. `otherwise`: the guess from which it starts again.
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y,
               const State<P>& otherwise) {
    newton_.begin();
    last_.forget_share();
    if (gamma_h != factored_for_ && !renew(t, gamma_h, y)) return Status::newton_failed;
    guess_ = otherwise;
    each_component(y, [&](std::size_t i) { increment_[i] = y[i] - base[i]; });
    for (int iteration = 0; iteration < max_iterations_; ++iteration) {
      problem_.rhs(t, y.data(), correction_.data());
      each_component(
          y, [&](std::size_t i) { correction_[i] = gamma_h * correction_[i] - increment_[i]; });
      if (!system_.solve(correction_.data(), correction_accuracy)) return fail();
      const double size = measure(base, y);
      const NewtonVerdict verdict = newton_.judge(size);
      const bool done = verdict == NewtonVerdict::done;
      if (!done && (verdict == NewtonVerdict::diverges || last_.share() != 1)) {
        if (!back_off(t, gamma_h, base, y)) return fail();
        continue;
      }
      last_.take(correction_, y, increment_);
      if (done) return Status::ok;
      newton_.taken(size);
      if (verdict == NewtonVerdict::slow && !renew(t, gamma_h, y)) return Status::newton_failed;
    }
    return fail();
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
  /// Called where the next correction did not shrink, or is not finite, or the last was taken in
  /// part. With a reused Jacobian: renews it at the guess and restarts there. With an older one of
  /// this solve: renews it at y. With one at the correction's own start: halves the correction
  /// until the next is smaller, then renews it (Deuflhard, Newton Methods for Nonlinear Problems,
  /// 3.3). False: gives up; a step that can be retried shorter does so at once.
  bool back_off(double t, double gamma_h, const State<P>& base, State<P>& y) {
    const bool fresh = newton_.fresh();
    const double rate = newton_.contraction();
    const bool finite = rate < NewtonSettings::never;
    if (fresh && (!to_rounding() || (newton_.corrections() == 0 && !finite))) return false;
    if (fresh && newton_.corrections() == 1 && !(rate <= 1 - last_.share() / 4)) {
      last_.take_share(last_.share() / 2, y, increment_);
      return true;
    }
    if (!fresh)
      restart(base, y);
    else if (!finite)
      last_.take_share(0, y, increment_);
    return renew(t, gamma_h, y);
  }
  void restart(const State<P>& base, State<P>& y) {
    y = guess_;
    each_component(y, [&](std::size_t i) { increment_[i] = y[i] - base[i]; });
  }
  Status fail() {
    factored_for_ = 0;
    return Status::newton_failed;
  }
  bool to_rounding() const { return accuracy_.relative() == 0; }
  /// Size of the correction; one is small enough.
  double measure(const State<P>& base, const State<P>& y) const {
    if (to_rounding()) {
      const double size = max_norm(correction_);
      if (size == 0) return 0;  // the state may be zero too
      return size / (iteration_tolerance * std::max({max_norm(y), max_norm(base), smallest_state}));
    }
    double sum = 0;
    each_component(y, [&](std::size_t i) {
      const double scaled = correction_[i] / accuracy_(i, std::abs(base[i]));
      sum += scaled * scaled;
    });
    return std::sqrt(sum / static_cast<double>(y.size()));
  }

  const P& problem_;
  ShiftedSystem<P> system_;
  State<P> correction_, guess_;
  LastCorrection<State<P>> last_;
  State<P> increment_;       ///< gamma_h f: rounded by itself, not as the state that it is added to
  double factored_for_ = 0;  ///< gamma_h of the factors; 0: none
  ErrorScale<State<P>> accuracy_;
  int max_iterations_ = 50;
  // A large contraction asks for a new Jacobian: sooner for a reused one, since the next steps
  // profit too.
  using Convergence = SimplifiedNewton<NewtonSettings{
      .slow_kept = 0.05, .slow_fresh = 0.1, .small_suffices = true}>;
  Convergence newton_;
};

}  // namespace odeum
